// Functions and classes that all steps of the browser test share: they start the browser, save
// pictures, wait for the page, and count clicks.
import fs from 'node:fs';
import path from 'node:path';
import { chromium } from 'playwright-core';

// Arguments of Chromium that let WebGL work without a graphics card.
const ARGUMENTS = [
  '--no-sandbox',
  '--disable-gpu',
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];

// Pixels of the screen for each pixel of the page.
const SCALE = Number(process.env['OPENR_PANEL_SCALE'] ?? '1');

// Returns the options of a page of this size. `colorScheme` is 'dark' or 'light'.
export function pageOptions(width, height, colorScheme) {
  return { viewport: { width, height }, colorScheme, deviceScaleFactor: SCALE };
}

export async function launch() {
  const executablePath = process.env['OPENR_CHROMIUM'] ?? '/usr/bin/chromium';
  return chromium.launch({ executablePath, args: ARGUMENTS });
}

export function need(condition, text) {
  if (!condition) throw new Error(text);
}

// Waits until `read` returns a value for which `isGood` holds, and returns it.
export async function until(what, read, isGood, timeoutMs = 60_000) {
  const end = Date.now() + timeoutMs;
  let value;
  do {
    value = await read();
    if (isGood(value)) return value;
    await new Promise((resolve) => setTimeout(resolve, 100));
  } while (Date.now() < end);
  throw new Error(`${what}; after ${timeoutMs / 1000} s the page shows ${JSON.stringify(value)}`);
}

export function numberOf(text) {
  return Number.parseFloat(String(text).replace('\u2212', '-'));
}

// Returns the seconds of a time that the page shows: 62.5 for "1:02.500".
export function secondsOf(text) {
  const [minutes = '0', seconds = '0'] = String(text).split(':');
  return Number(minutes) * 60 + Number(seconds);
}

export class Steps {
  passed = 0;
  failed = [];

  // `only`: a text; only steps whose names contain it are taken. "" takes all steps.
  constructor(folder, only = '') {
    this.folder = folder;
    this.only = only;
    if (folder) fs.mkdirSync(folder, { recursive: true });
  }

  // Takes a step: calls `act`, and counts and prints the result. A step whose name does not contain
  // `only` is left out. Returns false only if the step failed.
  // `isAlways`: takes the step whatever its name, because other steps need it.
  async step(name, page, act, isAlways = false) {
    if (!isAlways && !name.includes(this.only)) return true;
    const began = Date.now();
    try {
      await act();
      this.passed += 1;
      console.log(`ok      ${name} (${((Date.now() - began) / 1000).toFixed(1)} s)`);
      return true;
    } catch (error) {
      this.failed.push(name);
      console.log(`FAILED  ${name}: ${error.message.split('\nBrowser logs')[0]}`);
      await this.picture(page, `failed ${name}`).catch(() => undefined);
      return false;
    }
  }

  async picture(page, name) {
    if (!this.folder) return;
    const file = `${name.toLowerCase().replace(/[^a-z0-9]+/g, '-')}.png`;
    await page.screenshot({ path: path.join(this.folder, file) });
  }

  end() {
    console.log(`${this.passed} passed, ${this.failed.length} failed`);
    return this.failed.length === 0 ? 0 : 1;
  }
}

// The panel in a page of the browser. Finds controls by the names that a person reads.
export class Panel {
  clicks = 0;

  constructor(page) {
    this.page = page;
  }

  async click(locator) {
    this.clicks += 1;
    await locator.click({ timeout: 60_000 });
  }

  button(name) {
    return this.page.getByRole('button', { name, exact: true });
  }

  // Clicks the tab of a panel, unless the panel is shown already.
  async show(title) {
    const tab = this.page.getByRole('tab', { name: title, exact: true });
    if ((await tab.getAttribute('aria-selected')) !== 'true') await this.click(tab);
  }

  // Calls `act`, and throws if it needs more than three clicks.
  async inThreeClicks(act) {
    this.clicks = 0;
    await act();
    need(this.clicks <= 3, `it took ${this.clicks} clicks; three are allowed`);
  }

  state() {
    return this.page.locator('header .chip').first().textContent();
  }

  async time() {
    return secondsOf(await this.page.getByLabel('Virtual time').textContent());
  }

  joint(title) {
    return this.page.getByRole('group', { name: title, exact: true });
  }

  async measured(title) {
    return numberOf(await this.joint(title).locator('.measured').textContent());
  }

  // Drags the handle of a joint to `share` (0 to 1) of its range; returns that angle. Like a person,
  // tries again if the mouse has missed the handle, because the page can move under it.
  async dragJoint(title, share) {
    this.clicks += 1;
    for (let left = 3; ; --left) {
      const { goal, reached } = await this.#dragOnce(title, share);
      if (Math.abs(reached - goal) < 3 || left === 1) return goal;
    }
  }

  async #dragOnce(title, share) {
    const slider = this.page.getByRole('slider', { name: title, exact: true });
    // For a new run the page makes new sliders, and locks them until the first values of the run come.
    await until(`the slider of ${title} stays locked`, () => slider.isDisabled(), (is) => !is);
    await slider.scrollIntoViewIfNeeded();
    const box = await this.#restingBox(slider);
    const [min, max, value] = await slider.evaluate((e) => [e.min, e.max, e.value].map(Number));
    const at = (part) => box.x + 4 + part * (box.width - 8);
    await this.page.mouse.move(at((value - min) / (max - min)), box.y + box.height / 2);
    await this.page.mouse.down();
    await this.page.mouse.move(at(share), box.y + box.height / 2, { steps: 8 });
    await this.page.mouse.up();
    return { goal: min + share * (max - min), reached: Number(await slider.inputValue()) };
  }

  // Returns the place of an element on the page after it has been the same twice.
  async #restingBox(locator) {
    let last = '';
    return until(
      'the element moves on the page',
      () => locator.boundingBox(),
      (box) => {
        const isSame = JSON.stringify(box) === last;
        last = JSON.stringify(box);
        return isSame && box !== null;
      },
    );
  }

  sensor(name) {
    return this.page.locator(`[data-sensor="${name}"] .value`).textContent();
  }

  // Returns the texts of the error messages at the lower edge of the page.
  async errors() {
    return this.page.locator('.notice.bad .text').allTextContents();
  }

  async closeNotices() {
    const close = this.page.locator('.notice .close');
    const closeOne = async () => {
      await close.first().click({ timeout: 1000 }).catch(() => undefined);
      return close.count();
    };
    await until('a message stays', closeOne, (count) => count === 0);
  }
}
