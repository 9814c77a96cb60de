// Tests the page at the sizes of a phone, a tablet and a large screen.
import { need, pageOptions, Panel, until } from './browser.mjs';

const SIZES = [
  ['phone', 390, 844],
  ['tablet', 900, 1200],
  ['large', 2560, 1300],
];

export async function stepsOfPhone(steps, browser, wide) {
  for (const [name, width, height] of SIZES) {
    await steps.step(`the page fits into ${width} x ${height}`, wide.page, async () => {
      const page = await browser.newPage(pageOptions(width, height, 'light'));
      try {
        await page.goto(process.env['OPENR_PANEL_URL']);
        await page.locator('.link[data-state="open"]').waitFor({ timeout: 60_000 });
        await page.locator('.joint').nth(1).waitFor({ timeout: 60_000 });
        await page.waitForTimeout(1500);
        const over = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
        need(over <= 0, `the page is ${over} pixels too wide`);
        await steps.picture(page, name);
        if (name === 'phone') await tasksOnPhone(steps, new Panel(page));
      } finally {
        await page.close();
      }
    });
  }
}

async function tasksOnPhone(steps, panel) {
  const { page } = panel;
  await panel.inThreeClicks(async () => {
    await panel.show('Graph');
    need(/wait/.test(await page.locator('.graph-summary').textContent()), 'nothing says which object waits');
    await steps.picture(page, 'phone graph');
  });
  await panel.inThreeClicks(async () => {
    await panel.show('Sensors');
    await panel.click(page.getByRole('button', { name: 'Press chin' }));
    need((await panel.errors()).length === 0, (await panel.errors()).join('; '));
  });
  await panel.inThreeClicks(async () => {
    await panel.show('Motions');
    await panel.click(panel.button('Show the motions of the robot'));
    await until('no motion is listed', () => page.locator('.motion').count(), (n) => n > 0);
    await steps.picture(page, 'phone motions');
  });
  await panel.inThreeClicks(async () => {
    await panel.show('Joints');
    const text = await page.locator('.largest-error').textContent();
    need(/Largest error: \w+ /.test(text), `no joint is named: ${text}`);
  });
}
