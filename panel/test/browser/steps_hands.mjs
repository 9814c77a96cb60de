// Tests the controls for what a person does to the dog: sliders, pressing, pushing, lifting.
import { need, until } from './browser.mjs';

// Moves the pointer over the dog, from the middle of the picture outwards, until the picture shows
// the tooltip `title`. Returns that position of the pointer, or null.
async function findInPicture(page, title) {
  const canvas = page.locator('.picture canvas');
  const box = await canvas.boundingBox();
  const offsets = Array.from({ length: 13 }, (_, i) => Math.ceil(i / 2) * (i % 2 === 0 ? 14 : -14));
  for (const dy of offsets) {
    for (const dx of offsets) {
      const [x, y] = [box.x + box.width / 2 + dx, box.y + box.height / 2 + dy];
      await page.mouse.move(x, y);
      if ((await canvas.getAttribute('title')) === title) return [x, y];
    }
  }
  return null;
}

export async function stepsOfHands(steps, panel) {
  const { page } = panel;

  await steps.step('three clicks: turn the head', page, () =>
    panel.inThreeClicks(async () => {
      await panel.show('Joints');
      const goal = await panel.dragJoint('Neck pan', 0.75);
      await until(
        `the neck did not come to ${goal.toFixed(1)} degrees`,
        () => panel.measured('Neck pan'),
        (deg) => Math.abs(deg - goal) < 3,
      );
      need((await panel.errors()).length === 0, (await panel.errors()).join('; '));
      await steps.picture(page, 'head turned');
    }),
  );

  await steps.step('a slider obeys the keyboard', page, async () => {
    const before = await panel.measured('Neck pan');
    await page.getByRole('slider', { name: 'Neck pan', exact: true }).focus();
    for (let i = 0; i < 10; ++i) await page.keyboard.press('PageDown');
    await until(
      'the neck did not turn back',
      () => panel.measured('Neck pan'),
      (deg) => deg < before - 8,
    );
  });

  await steps.step('speed of all joints is set, at most to the largest of each', page, async () => {
    const slider = page.getByRole('slider', { name: 'Speed of all joints' });
    await slider.focus();
    for (let i = 0; i < 2; ++i) await page.keyboard.press('PageDown');
    await page.locator('.notice.good', { hasText: 'Speed of all joints' }).first().waitFor({ timeout: 60_000 });
    need((await panel.errors()).length === 0, (await panel.errors()).join('; '));
  });

  await steps.step('three clicks: press the chin', page, () =>
    panel.inThreeClicks(async () => {
      await panel.show('Sensors');
      const chin = page.getByRole('button', { name: 'Press chin' });
      await until('the chin was pressed before', () => panel.sensor('chin'), (s) => s === 'released');
      const box = await chin.boundingBox();
      panel.clicks += 1;
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      await page.mouse.down();
      await until('the sensor shows no press', () => panel.sensor('chin'), (s) => s === 'pressed');
      await page.mouse.up();
      await until('the sensor stayed pressed', () => panel.sensor('chin'), (s) => s === 'released');
    }),
  );

  await steps.step('the keyboard presses the back as long as a key is held', page, async () => {
    await page.getByRole('button', { name: 'Press back', exact: true }).focus();
    await page.keyboard.down('Space');
    await until('the sensor shows no press', () => panel.sensor('back'), (s) => s === 'pressed');
    await page.keyboard.up('Space');
    await until('the sensor stayed pressed', () => panel.sensor('back'), (s) => s === 'released');
  });

  await steps.step('the back is pressed in the picture', page, async () => {
    await panel.click(panel.button('Top'));
    await panel.show('Sensors');
    await page.waitForTimeout(800);
    const at = await findInPicture(page, 'Press back');
    need(at !== null, 'no place of the picture says "Press back"');
    await page.mouse.down();
    await until('the sensor shows no press', () => panel.sensor('back'), (s) => s === 'pressed');
    await page.mouse.up();
    await until('the sensor stayed pressed', () => panel.sensor('back'), (s) => s === 'released');
    await panel.click(panel.button('Reset'));
    await page.waitForTimeout(800);
  });

  await steps.step('a drag on the dog shows a force and pushes', page, async () => {
    await panel.closeNotices();
    const box = await page.locator('.picture canvas').boundingBox();
    const [x, y] = [box.x + box.width * 0.49, box.y + box.height * 0.5];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 45, y - 5, { steps: 6 });
    const force = await until(
      'no arrow appeared',
      () => page.locator('.force.shown text').allTextContents(),
      (all) => all.length === 1,
    );
    await page.mouse.up();
    need(/^4\.\d N$/.test(force[0]), `the arrow of 45 pixels says ${force[0]}`);
    await page.waitForTimeout(600);
    need((await panel.errors()).length === 0, (await panel.errors()).join('; '));
  });

  await steps.step('the dog is lifted and set down', page, async () => {
    await panel.show('Sensors');
    await panel.click(panel.button('Lift 10 cm'));
    await until('a paw stayed on the floor', () => panel.sensor('paw_LF'), (s) => s === 'released');
    await steps.picture(page, 'lifted');
    await panel.click(panel.button('Set down'));
    await until('the paw did not come back', () => panel.sensor('paw_LF'), (s) => s === 'pressed');
  });
}
