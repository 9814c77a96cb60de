// Tests the panel of a run in a browser: uses only the controls that a person can use.
//
//   OPENR_PANEL_URL=http://127.0.0.1:8210/?token=... node test/browser/panel_test.mjs [WORD]
//
// WORD: takes only the steps whose names contain WORD. Other variables of the environment:
//   OPENR_PANEL_SHOTS: the folder for screenshots.
//   OPENR_PANEL_SCALE: pixels of a screenshot for each pixel of the page; default 1.
//   OPENR_PANEL_MOTION: a motion that the test uploads.
//   OPENR_PANEL_CONTROLLER: a controller image that the test uploads; it prints "iteration 1".
//   OPENR_PANEL_SECOND, OPENR_PANEL_LINK: see steps_both.mjs.
//   OPENR_CHROMIUM: the browser.
import fs from 'node:fs';
import { launch, pageOptions, Panel, Steps } from './browser.mjs';
import { stepsOfBoth } from './steps_both.mjs';
import { stepsOfHands } from './steps_hands.mjs';
import { stepsOfRobot } from './steps_robot.mjs';
import { stepsOfTime } from './steps_time.mjs';
import { stepsOfPhone } from './steps_phone.mjs';
import { stepsOfConnecting, stepsOfViews } from './steps_views.mjs';

const url = process.env['OPENR_PANEL_URL'];
const motion = process.env['OPENR_PANEL_MOTION'] ?? '';
if (!url || (motion !== '' && !fs.existsSync(motion))) {
  console.error('Set OPENR_PANEL_URL to the address that openr run prints, OPENR_PANEL_MOTION to an .MTN file.');
  process.exit(2);
}

const steps = new Steps(process.env['OPENR_PANEL_SHOTS'] ?? '', process.argv[2] ?? '');
const browser = await launch();
const problems = [];
try {
  const page = await browser.newPage({ ...pageOptions(1440, 900, 'dark'), acceptDownloads: true });
  page.on('pageerror', (error) => problems.push(error.message));
  page.on('console', (message) => {
    if (message.type() === 'error') problems.push(message.text());
  });
  const elsewhere = [];
  page.on('request', (request) => {
    if (!request.url().startsWith(new URL(url).origin) && !/^(data|blob):/.test(request.url()))
      elsewhere.push(request.url());
  });
  await page.goto(url);
  const panel = new Panel(page);
  if (!(await stepsOfConnecting(steps, panel))) process.exit(steps.end());
  await stepsOfViews(steps, panel);
  await stepsOfHands(steps, panel);
  await stepsOfRobot(steps, panel, motion);
  await stepsOfPhone(steps, browser, panel);
  await stepsOfBoth(steps, browser, panel, motion);
  await stepsOfTime(steps, panel, process.env['OPENR_PANEL_CONTROLLER'] ?? '');
  await steps.step('the page loads nothing from elsewhere', page, () => {
    if (elsewhere.length > 0) throw new Error(elsewhere.join(', '));
  });
  await steps.step('the page has no errors in its console', page, () => {
    if (problems.length > 0) throw new Error([...new Set(problems)].join('; '));
  });
} finally {
  await browser.close();
}
process.exit(steps.end());
