// Tests the controls of time: pause, single steps, rate, going back, and a new run from the past.
import { need, until } from './browser.mjs';

export async function stepsOfTime(steps, panel, controller) {
  const { page } = panel;

  await steps.step('a pause stops the time, steps go on a little', page, async () => {
    await panel.click(panel.button('❚❚ Pause'));
    await panel.button('▶ Run').waitFor({ timeout: 60_000 });
    await page.waitForTimeout(500);
    const before = await panel.time();
    await page.waitForTimeout(700);
    need((await panel.time()) === before, 'the time went on');
    await panel.click(panel.button('Frame'));
    await until('one frame is not 8 ms', () => panel.time(), (t) => Math.abs(t - before - 0.008) < 0.0081);
    await panel.click(panel.button('Message'));
    const vector = await panel.time();
    // Several objects can handle one vector at the same virtual time, and each click goes on by one
    // of them. So one click may leave the time as it is, but four change it.
    for (let i = 0; i < 4; ++i) await panel.click(panel.button('Vector'));
    await until('a vector did not go on', () => panel.time(), (t) => t > vector && t < vector + 0.3);
    await panel.click(panel.button('▶ Run'));
    await until('the time did not go on', () => panel.time(), (t) => t > before + 1);
  });

  await steps.step('the rate can be chosen', page, async () => {
    const rate = page.getByLabel('Rate: virtual seconds per second');
    await rate.selectOption('0.25');
    await until(
      'the run did not get slower',
      () => page.locator('.speed').textContent(),
      (text) => Number(/([\d.]+)×/.exec(text)?.[1]) < 0.5,
    );
    await rate.selectOption('1');
  });

  await steps.step('three clicks: go back five seconds', page, () =>
    panel.inThreeClicks(async () => {
      const before = await panel.time();
      await panel.click(panel.button('Back five seconds'));
      await page.locator('.moment[data-kind="past"]').waitFor({ timeout: 60_000 });
      const after = await panel.time();
      need(after < before - 3.5 && after > before - 6.5, `from ${before} s the page went to ${after} s`);
      await page.waitForTimeout(600);
      need((await panel.time()) === after, 'the past went on');
      await steps.picture(page, 'five seconds ago');
    }),
  );

  await steps.step('sliders are locked while the past is shown', page, async () => {
    await panel.show('Joints');
    await until(
      'the slider is free',
      () => page.getByRole('slider', { name: 'Neck pan', exact: true }).isDisabled(),
      (is) => is,
    );
  });

  await steps.step('the time slider goes to another moment, and to the present', page, async () => {
    const before = await panel.time();
    await page.getByRole('slider', { name: 'Moment shown' }).focus();
    for (let i = 0; i < 2; ++i) await page.keyboard.press('PageDown');
    await until('the moment shown did not change', () => panel.time(), (t) => t < before - 0.2);
    await panel.click(panel.button('Present'));
    await until('the present is not shown', () => page.locator('.moment[data-kind="past"]').count(), (n) => n === 0);
  });

  await steps.step('a new run goes on from the past', page, async () => {
    const run = page.getByLabel('Run', { exact: true });
    const first = await run.inputValue();
    await panel.click(panel.button('Back five seconds'));
    await page.locator('.moment[data-kind="past"]').waitFor({ timeout: 60_000 });
    const from = await panel.time();
    await panel.click(panel.button('Go on from here'));
    await until('the page did not go to a new run', () => run.inputValue(), (name) => name !== '' && name !== first);
    await until('the new run did not go on', () => panel.time(), (t) => t > from && t < from + 30);
    await steps.picture(page, 'branch');
  });

  await steps.step('the new run obeys the remote control', page, async () => {
    await panel.closeNotices();
    await panel.show('Joints');
    await until('the dog of the new run is not ready', () => panel.state(), (state) => state === 'accepting-commands');
    const goal = await panel.dragJoint('Neck pan', 0.3);
    await until(
      `the neck did not come to ${goal.toFixed(1)} degrees`,
      () => panel.measured('Neck pan'),
      (deg) => Math.abs(deg - goal) < 3,
    );
    need((await panel.errors()).length === 0, (await panel.errors()).join('; '));
  });

  if (controller !== '') {
    await steps.step('the robot boots again with another controller', page, async () => {
      await panel.closeNotices();
      await panel.show('Robot');
      const wait = page.waitForEvent('filechooser', { timeout: 60_000 });
      await panel.click(panel.button('Upload controller'));
      await (await wait).setFiles(controller);
      await page.locator('.hint', { hasText: 'Reboot to run it' }).waitFor({ timeout: 60_000 });
      await panel.click(panel.button('Reboot'));
      const question = page.getByRole('group', { name: 'Reboot the robot?' });
      await panel.click(question.getByRole('button', { name: 'Reboot' }));
      await until('the robot is not off', () => panel.state(), (state) => /off, boots in \d s/.test(state));
      await steps.picture(page, 'off');
      await page.getByLabel('Rate: virtual seconds per second').selectOption('10');
      await until('the dog does not stand up', () => panel.state(), (state) => state === 'accepting-commands');
      await page.getByLabel('Rate: virtual seconds per second').selectOption('1');
      await panel.show('Log');
      await until('the new controller says nothing', () => page.locator('#panel-log').textContent(), (text) => text.includes('iteration 1'));
      await panel.show('Joints');
      const goal = await panel.dragJoint('Neck pan', 0.6);
      await until('the neck does not obey', () => panel.measured('Neck pan'), (deg) => Math.abs(deg - goal) < 3);
    });
  }

  await steps.step('the page says that the run has ended', page, async () => {
    await panel.show('Robot');
    await panel.click(panel.button('Shut down'));
    const question = page.getByRole('group', { name: 'Shut the robot down?' });
    await panel.click(question.getByRole('button', { name: 'Shut down' }));
    await page.locator('.banner', { hasText: 'The run has ended' }).waitFor({ timeout: 60_000 });
    await steps.picture(page, 'ended');
  });
}
