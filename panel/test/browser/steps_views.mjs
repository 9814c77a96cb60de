// Tests what the page shows: the dog, joints, graph, plots, log.
import fs from 'node:fs';
import { need, until } from './browser.mjs';

const CONNECTION = '.edge.active text';

async function saved(panel, name) {
  const wait = panel.page.waitForEvent('download', { timeout: 60_000 });
  await panel.click(panel.button(name));
  return fs.readFileSync(await (await wait).path(), 'utf8');
}

// Returns whether the page is connected; without a connection the other steps make no sense.
export async function stepsOfConnecting(steps, panel) {
  const { page } = panel;
  return steps.step('the page connects and hides its token', page, async () => {
    await page.locator('.link[data-state="open"]').waitFor({ timeout: 60_000 });
    need(!page.url().includes('token'), `the address still has the token: ${page.url()}`);
    await page.locator('.joint').nth(1).waitFor({ timeout: 60_000 });
    await until('the page shows no time', () => panel.time(), (t) => t > 0);
  }, true);
}

export async function stepsOfViews(steps, panel) {
  const { page } = panel;

  await steps.step('the dog stands up', page, async () => {
    await until('JointMover did not get ready', () => panel.state(), (s) => s === 'accepting-commands', 240_000);
    await steps.picture(page, 'wide dark');
  });

  await steps.step('a view and a drag beside the dog change the picture', page, async () => {
    const canvas = page.locator('.picture canvas');
    const front = await canvas.screenshot();
    await panel.click(panel.button('Top'));
    await page.waitForTimeout(900);
    const top = await canvas.screenshot();
    need(!front.equals(top), 'the view from the top looks like the one before');
    const box = await canvas.boundingBox();
    await page.mouse.move(box.x + 20, box.y + 40);
    await page.mouse.down();
    await page.mouse.move(box.x + 180, box.y + 10, { steps: 5 });
    await page.mouse.up();
    await page.waitForTimeout(900);
    need(!top.equals(await canvas.screenshot()), 'the drag did not turn the picture');
    await panel.click(panel.button('Reset'));
  });

  await steps.step('three clicks: find the joint with the largest error', page, () =>
    panel.inThreeClicks(async () => {
      const text = await page.locator('.largest-error').textContent();
      const name = /Largest error: (\w+) /.exec(text)?.[1];
      need(name !== undefined, `no joint is named: ${text}`);
      await panel.click(panel.button('Sort by error'));
      await until(
        'the first joint is not marked',
        () => page.locator('.joint-list .joint').first().getAttribute('class'),
        (s) => s.includes('largest'),
      );
      need((await panel.errors()).length === 0, (await panel.errors()).join('; '));
      await panel.click(panel.button('Sort by error'));
    }),
  );

  await steps.step('three clicks: find the object that waits', page, () =>
    panel.inThreeClicks(async () => {
      await panel.show('Graph');
      const text = await page.locator('.graph-summary').textContent();
      need(/waits/.test(text), `the graph does not say which object waits: ${text}`);
    }),
  );

  await steps.step('the graph shows messages', page, async () => {
    await panel.show('Graph');
    await until(
      'no connection has messages',
      () => page.locator(CONNECTION).allTextContents(),
      (all) => all.some((text) => /[1-9][0-9.]*\/s/.test(text)),
    );
    await panel.click(page.locator(CONNECTION).first());
    await until(
      'no decoded message appeared',
      () => page.locator('.messages .number').allTextContents(),
      (all) => all.some((text) => /^#\d+$/.test(text)),
    );
    await steps.picture(page, 'connection');
    await panel.click(page.getByRole('button', { name: 'Close the messages' }));
  });

  await steps.step('the graph is a list as well', page, async () => {
    await panel.click(panel.button('List'));
    await page.locator('.graph-row').first().waitFor();
    const text = await page.locator('button.graph-row').first().textContent();
    need(/ready|unknown/.test(text), `a row does not say whether it is ready: ${text}`);
    await panel.click(panel.button('Picture'));
  });

  await steps.step('a plot is saved as SVG and CSV', page, async () => {
    await panel.show('Plots');
    await page.getByLabel('Add a series to the plot').selectOption({ label: 'acceleration_z' });
    await page.getByLabel('Add a series to the plot').selectOption({ label: 'LF_j1, both' });
    await until(
      'the plot has no line of acceleration_z',
      () => page.locator('[data-series="sensor:acceleration_z"]').count(),
      (n) => n === 1,
    );
    await page.waitForTimeout(1500);
    const svg = await saved(panel, 'Save SVG');
    need(svg.includes('<svg') && svg.includes('acceleration_z'), 'the SVG has no acceleration_z');
    need(/stroke-dasharray/.test(svg), 'commanded and measured do not differ by dashes');
    const rows = (await saved(panel, 'Save CSV')).trim().split('\n');
    need(rows.length > 5, `the CSV has ${rows.length} lines`);
    need(
      rows[0].startsWith('time_s,neck_pan commanded') && rows[0].includes('LF_j1 measured'),
      `the CSV begins with ${rows[0]}`,
    );
    need(rows.every((row) => row.split(',').length === 6), 'a line of the CSV does not have 6 columns');
    await steps.picture(page, 'plots');
  });

  await steps.step('the log can be filtered', page, async () => {
    await panel.show('Log');
    await page.getByLabel('Filter of the log').fill('standing');
    await until(
      'no line has the word',
      () => page.locator('.log-lines span').allTextContents(),
      (all) => all.length > 0 && all.every((text) => text.includes('standing')),
    );
    await page.getByLabel('Filter of the log').fill('');
    await panel.show('Graph');
  });

  await steps.step('light and dark can be switched', page, async () => {
    await panel.click(page.getByRole('button', { name: 'Switch to light colours' }));
    await page.waitForTimeout(800);
    await steps.picture(page, 'wide light');
    need((await page.locator('html').getAttribute('data-theme')) === 'light', 'the page stayed dark');
    await panel.click(page.getByRole('button', { name: 'Switch to dark colours' }));
  });
}
