// Tests the panel of the robot: motions, files, lights, battery.
import path from 'node:path';
import { need, until } from './browser.mjs';

async function chooseFile(panel, label, file) {
  const wait = panel.page.waitForEvent('filechooser', { timeout: 60_000 });
  await panel.click(panel.button(label));
  await (await wait).setFiles(file);
}

export async function stepsOfRobot(steps, panel, motion) {
  const { page } = panel;
  const name = path.basename(motion).toUpperCase();

  await steps.step('three clicks: play a motion', page, () =>
    panel.inThreeClicks(async () => {
      await panel.click(panel.button('Show the motions of the robot'));
      await panel.click(panel.button('Play BOW.MTN'));
      await until('the motion did not begin', () => panel.state(), (s) => s.includes('mtn'));
      await panel.show('Joints');
      await page.locator('.lock').waitFor({ timeout: 60_000 });
      need(await page.getByRole('slider', { name: 'Neck pan', exact: true }).isDisabled(), 'sliders are not locked');
      await steps.picture(page, 'motion plays');
      await until('the motion did not end', () => panel.state(), (s) => s === 'accepting-commands', 60_000);
    }),
  );

  if (motion !== '') {
    const row = page.locator(`.motion[data-name="${name}"]`);
    await steps.step('a motion is uploaded', page, async () => {
      await chooseFile(panel, 'Upload .MTN', motion);
      await page.locator('.notice.good', { hasText: 'uploaded' }).first().waitFor({ timeout: 60_000 });
      await until('the motion is not listed', () => row.count(), (n) => n === 1);
    });

    await steps.step('an uploaded motion plays in loops and stops', page, async () => {
      await page.getByLabel('Loops', { exact: true }).fill('3');
      await panel.click(panel.button(`Play ${name}`));
      const text = () => page.locator('.progress-text').textContent();
      await until('no progress is shown', text, (s) => /loop \d of 3/.test(s), 60_000);
      await panel.click(panel.button('■ Stop'));
      await until('the motion did not stop', () => panel.state(), (s) => s === 'accepting-commands');
    });

    await steps.step('a motion is deleted after a question', page, async () => {
      await panel.click(panel.button(`Delete ${name}`));
      need((await row.count()) === 1, 'the motion was deleted without a question');
      await panel.click(row.getByRole('button', { name: 'Delete', exact: true }));
      await until('the motion is still listed', () => row.count(), (n) => n === 0);
    });
  }

  await steps.step('a file that is no motion is refused with a reason', page, async () => {
    await panel.closeNotices();
    await chooseFile(panel, 'Upload .MTN', { name: 'BAD.MTN', mimeType: 'application/octet-stream', buffer: Buffer.from('no motion') });
    await page.locator('.notice.bad', { hasText: 'BAD.MTN was not uploaded' }).waitFor({ timeout: 60_000 });
    await panel.closeNotices();
  });

  await steps.step('a light and an ear are switched', page, async () => {
    await panel.show('Robot');
    for (const device of ['Tail light (blue)', 'Left ear']) {
      const toggle = page.locator('.toggle', { hasText: device });
      const before = await toggle.getAttribute('aria-pressed');
      await panel.click(toggle);
      await until(`${device} did not change`, () => toggle.getAttribute('aria-pressed'), (s) => s !== before);
    }
    need((await panel.errors()).length === 0, (await panel.errors()).join('; '));
    await steps.picture(page, 'robot');
  });

  await steps.step('the battery is set', page, async () => {
    const slider = page.getByRole('slider', { name: 'Battery in percent' });
    await slider.focus();
    for (let i = 0; i < 5; ++i) await page.keyboard.press('PageDown');
    const wanted = await slider.inputValue();
    await until(
      'the battery did not follow',
      () => page.locator('header .chips').textContent(),
      (text) => Math.abs(Number(/battery (\d+)%/.exec(text)?.[1]) - Number(wanted)) <= 1,
    );
  });

  await steps.step('shutting down asks first', page, async () => {
    await panel.click(panel.button('Shut down'));
    const question = page.getByRole('group', { name: 'Shut the robot down?' });
    await question.waitFor();
    await panel.click(question.getByRole('button', { name: 'No' }));
    need((await question.count()) === 0, 'the question stayed');
  });
}
