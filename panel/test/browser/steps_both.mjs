// Tests the panel with a second robot: another run, behind a link that the test can cut.
//
// OPENR_PANEL_SECOND: the address of the second robot, through the link.
// OPENR_PANEL_LINK: the address of the control of the link.
import net from 'node:net';
import { need, numberOf, pageOptions, Panel, until } from './browser.mjs';

// Sends a line to the control of the link (tests/both/link.py).
function tellLink(line) {
  const [host, port] = process.env['OPENR_PANEL_LINK'].split(':');
  return new Promise((resolve, reject) => {
    const socket = net.connect(Number(port), host, () => socket.write(`${line}\n`));
    socket.once('data', () => {
      socket.end();
      resolve();
    });
    socket.once('error', reject);
  });
}

export async function stepsOfBoth(steps, browser, panel, motion) {
  const { page } = panel;
  const address = process.env['OPENR_PANEL_SECOND'] ?? '';
  if (address === '') return;
  const box = page.getByRole('checkbox', { name: 'Simulation', exact: true });
  const follow = page.getByLabel('Follow', { exact: true });
  const rate = page.getByLabel('Rate: virtual seconds per second');
  const fact = (name) => page.locator(`.facts dt:text-is("${name}") + dd`).textContent();
  const difference = async () => numberOf((await fact('Largest difference')).split(' ')[1]);
  // Returns by how many degrees the necks of robot and simulation differ, from the marks that the
  // slider shows.
  const neckDifference = async () => {
    await panel.show('Joints');
    const shares = await panel
      .joint('Neck pan')
      .locator('.track')
      .evaluate((e) => [e.style.getPropertyValue('--other'), e.style.getPropertyValue('--at')].map(Number));
    return Math.abs(shares[0] - shares[1]) * 180;
  };
  const connect = async () => {
    await panel.show('Both dogs');
    await page.getByLabel('Address of the second robot').fill(address);
    await panel.click(panel.button('Connect'));
    await panel.button('Disconnect').waitFor({ timeout: 60_000 });
  };
  // Drags the slider of the neck, and shows the panel "Both dogs" again; returns the commanded angle.
  const drag = async (share) => {
    await panel.show('Joints');
    const goal = await panel.dragJoint('Neck pan', share);
    await panel.show('Both dogs');
    return goal;
  };

  await steps.step('both: without a second robot the box is checked and locked', page, async () => {
    await panel.closeNotices();
    await panel.show('Both dogs');
    need((await box.isChecked()) && (await box.isDisabled()), 'the box can be changed');
    await page.getByLabel('Address of the second robot').fill('127.0.0.1:1');
    await panel.click(panel.button('Connect'));
    await page.locator('.both .lost', { hasText: 'no program listens there' }).waitFor({ timeout: 60_000 });
    await steps.picture(page, 'both refused');
    await panel.closeNotices();
  });

  await steps.step('both: three clicks connect a second robot, in real time', page, async () => {
    await until('the dog does not stand', () => panel.state(), (state) => state === 'accepting-commands', 120_000);
    await rate.selectOption('0.5');
    await panel.inThreeClicks(connect);
    need((await box.isChecked()) && !(await box.isDisabled()), 'the box is locked');
    await until('the run does not go in real time', () => rate.inputValue(), (value) => value === '1');
    await until(
      'nothing says why the run cannot go back',
      () => page.locator('.memory').textContent(),
      (text) => text.includes(address),
    );
    await panel.closeNotices();
  });

  await steps.step('both: a slider moves both dogs', page, async () => {
    const goal = await drag(0.7);
    await until(
      'the simulation did not move',
      async () => {
        await panel.show('Joints');
        return panel.measured('Neck pan');
      },
      (deg) => Math.abs(deg - goal) < 3,
    );
    await until('the dogs differ', neckDifference, (deg) => deg < 4);
    await steps.picture(page, 'both joints');
    need((await panel.errors()).length === 0, (await panel.errors()).join('; '));
  });

  await steps.step('both: without the box only the robot moves', page, async () => {
    await panel.show('Both dogs');
    await panel.click(box);
    await until('nothing says so', () => page.locator('.both .hint').first().textContent(), (s) => s.includes('robot only'));
    await drag(0.3);
    await until('the simulation moved, too', neckDifference, (deg) => deg > 20);
    await panel.show('Both dogs');
    await panel.click(box);
  });

  await steps.step('both: the simulation follows the robot, with its lag', page, async () => {
    await panel.show('Both dogs');
    await follow.selectOption('simulation');
    await until('the simulation did not follow', difference, (deg) => deg < 6);
    await drag(0.6);
    // The page shows a lag only while the dogs move. So we wait until panel and header both show it,
    // and only then take the screenshot.
    const lags = async () => [await fact('Lag of the pose'), await page.locator('.chip.pair').textContent()];
    await until('no lag is shown', lags, ([inPanel, inHead]) => /\d+ ms/.test(inPanel) && /lag \d+ ms/.test(inHead));
    await steps.picture(page, 'both follow');
  });

  await steps.step('both: the robot follows the simulation', page, async () => {
    await panel.show('Both dogs');
    await follow.selectOption('robot');
    await drag(0.45);
    await until('the robot did not follow', difference, (deg) => deg < 6);
    await follow.selectOption('none');
  });

  await steps.step('both: a motion plays on both', page, async () => {
    await panel.click(panel.button('Show the motions of the robot'));
    await panel.click(panel.button('Play WALK.MTN'));
    const shown = await until('no key frame is shown', () => fact('Motion'), (text) => /WALK\.MTN, key frame \d+, on both/.test(text));
    await steps.picture(page, 'both motion');
    await panel.show('Joints');
    await until('the motion did not end', () => page.locator('.lock').isVisible(), (is) => !is);
    need(shown !== '' && (await panel.errors()).length === 0, (await panel.errors()).join('; '));
  });

  if (motion !== '') {
    await steps.step('both: a file plays in the simulation only', page, async () => {
      const wait = page.waitForEvent('filechooser', { timeout: 60_000 });
      await panel.click(panel.button('Play a file'));
      await (await wait).setFiles(motion);
      await until('the simulation plays nothing', () => panel.state(), (state) => state.includes('mtn'));
      await panel.show('Both dogs');
      need((await fact('Motion')) === 'none', 'the robot plays, too');
      await panel.click(panel.button('■ Stop'));
      await until('the motion did not stop', () => panel.state(), (state) => state === 'accepting-commands');
    });
  }

  await steps.step('both: a link that is cut locks the box', page, async () => {
    await panel.closeNotices();
    await panel.show('Both dogs');
    await panel.click(box);
    await tellLink('cut');
    await until('the box is free', () => box.isDisabled(), (is) => is);
    need(await box.isChecked(), 'the box is not checked again');
    await page.locator('.notice.bad', { hasText: 'was lost' }).waitFor({ timeout: 60_000 });
    await until('the old rate does not come back', () => rate.inputValue(), (value) => value === '0.5');
    await steps.picture(page, 'both lost');
    await tellLink('go');
    await rate.selectOption('1');
    await panel.closeNotices();
  });

  await steps.step('both: the panel fits on a phone', page, async () => {
    const phone = await browser.newPage(pageOptions(390, 844, 'light'));
    try {
      await phone.goto(process.env['OPENR_PANEL_URL']);
      await phone.locator('.link[data-state="open"]').waitFor({ timeout: 60_000 });
      const small = new Panel(phone);
      await small.show('Both dogs');
      await phone.getByLabel('Address of the second robot').fill(address);
      await small.click(small.button('Connect'));
      await small.button('Disconnect').waitFor({ timeout: 60_000 });
      await phone.waitForTimeout(1500);
      const over = await phone.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      need(over <= 0, `the page is ${over} pixels too wide`);
      await steps.picture(phone, 'both phone');
      await small.click(small.button('Disconnect'));
      await until('it is not free again', () => small.button('Connect').count(), (n) => n === 1);
    } finally {
      await phone.close();
    }
  });
}
