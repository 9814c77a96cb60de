// Takes screenshots of the panel while the dog of a run walks. tools/moving_picture.py makes the
// moving picture of the README from them.
//
//   OPENR_PANEL_URL=http://... OPENR_PANEL_SHOTS=FOLDER node test/browser/frames.mjs
import fs from 'node:fs';
import path from 'node:path';
import { launch, Panel, until } from './browser.mjs';

const url = process.env['OPENR_PANEL_URL'];
const folder = process.env['OPENR_PANEL_SHOTS'];
const FRAMES = 20; // frames of 8 ms between two screenshots

const browser = await launch();
const page = await browser.newPage({ viewport: { width: 1440, height: 900 }, colorScheme: 'dark' });
await page.goto(url);
const panel = new Panel(page);
fs.mkdirSync(folder, { recursive: true });
// Pauses the run and takes `count` screenshots, with FRAMES frames of the run between them. In real
// time the dog would move too far between two, because a browser without a graphics card needs long
// for a screenshot.
async function film(count) {
  await page.keyboard.press('p');
  await until('the run does not pause', () => page.getByRole('button', { name: /Run/ }).count(), (n) => n > 0);
  for (let i = 0; i < count; i += 1) {
    const end = (await panel.time()) + FRAMES * 0.008 - 0.001;
    for (let frame = 0; frame < FRAMES; frame += 1) await page.keyboard.press('.');
    await until('the run stands still', () => panel.time(), (time) => time >= end);
    await page.screenshot({ path: path.join(folder, `${String(i).padStart(3, '0')}.png`) });
  }
}

await until('the dog does not stand up', () => panel.state(), (s) => s === 'accepting-commands', 120_000);
await panel.click(panel.button('Show the motions of the robot'));
await page.getByLabel('Loops', { exact: true }).fill('8');
await panel.click(panel.button('Play WALK.MTN'));
await until('the motion did not begin', () => panel.state(), (s) => s.includes('mtn'));
await film(24);
await browser.close();
