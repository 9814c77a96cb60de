// The panel of the whole robot: lights, ears, motors, battery, controller image, and switching the
// robot off.
import { button, el, setText } from '../dom';
import { confirmButton } from '../confirm';
import type { DeviceData } from '../protocol';
import type { Session } from '../session';
import { Touch } from './touch';
import { makeUpload } from './upload';

function section(title: string, ...children: (HTMLElement | string)[]): HTMLElement {
  return el('section', { class: 'block' }, el('h2', {}, title), ...children);
}

// Makes buttons that switch lights or ears. A symbol and a word on each button show whether it is
// on.
function makeToggles(session: Session, call: 'led' | 'ear', devices: DeviceData[]): HTMLElement[] {
  return devices.map((device, index) => {
    const toggle = button(
      '',
      () => {
        const on = toggle.getAttribute('aria-pressed') !== 'true';
        void session.rc(call, { index, on }, device.name);
      },
      { class: 'toggle', 'aria-pressed': 'false', title: device.locator, 'data-call': call, 'data-index': index },
    );
    toggle.append(el('span', { class: 'sign', 'aria-hidden': true }, '○'), el('span', {}, device.name));
    return toggle;
  });
}

function showToggle(toggle: HTMLElement, isOn: boolean): void {
  const text = String(isOn);
  if (toggle.getAttribute('aria-pressed') === text) return;
  toggle.setAttribute('aria-pressed', text);
  setText(toggle.firstElementChild as Element, isOn ? '●' : '○');
}

function makeDevices(session: Session): HTMLElement[] {
  const leds = el('div', { class: 'toggles' });
  const ears = el('div', { class: 'toggles' });
  const build = () => {
    const robot = session.scene?.robots[session.robot];
    leds.replaceChildren(...makeToggles(session, 'led', robot?.leds ?? []));
    ears.replaceChildren(...makeToggles(session, 'ear', robot?.ears ?? []));
  };
  session.on('scene', build);
  session.on('robot', build);
  session.on('pose', (pose) => {
    if (leds.offsetParent === null) return;
    const robot = pose.robots[session.robot];
    [...leds.children].forEach((each, i) => showToggle(each as HTMLElement, (robot?.leds?.[i] ?? 0) !== 0));
    // Shows an ear as on if its angle is near 0, because an ear that is on stands up.
    [...ears.children].forEach((each, i) =>
      showToggle(each as HTMLElement, Math.abs(robot?.ears?.[i] ?? 1) < 0.6),
    );
  });
  return [section('Lights', leds), section('Ears (on: standing up)', ears)];
}

function makeBattery(session: Session): HTMLElement {
  const slider = el('input', { type: 'range', min: 0, max: 100, step: 1, value: 100, 'aria-label': 'Battery in percent' });
  const text = el('span', { class: 'value' }, '100 %');
  const touch = new Touch();
  slider.addEventListener('input', () => {
    touch.begin();
    setText(text, `${slider.value} %`);
  });
  slider.addEventListener('change', () => {
    void session.input(`battery ${slider.value}%`).then(touch.change());
  });
  session.on('values', (values) => {
    const percent = values.robots[session.robot]?.battery?.percent;
    if (percent === undefined || !touch.isOver()) return;
    slider.value = String(percent);
    setText(text, `${percent} %`);
  });
  return section(
    'Battery',
    el('div', { class: 'row' }, slider, text),
    el(
      'div',
      { class: 'row' },
      button('Put on charger', () => void session.input('charger on')),
      button('Take off charger', () => void session.input('charger off')),
    ),
  );
}

function makePower(session: Session): HTMLElement {
  const act = async (call: string, more: Record<string, unknown>, done: string) => {
    if ((await session.rc(call, more, done)) !== null) session.good(done);
  };
  return section(
    'Power',
    el(
      'div',
      { class: 'row wrap' },
      confirmButton(
        { label: 'Motors off', question: 'Motors off? The dog sinks.', yes: 'Motors off' },
        () => void act('motors', { on: false }, 'Motors are off'),
      ),
      confirmButton(
        { label: 'Motors on', question: 'Motors on?', yes: 'Motors on' },
        () => void act('motors', { on: true }, 'Motors are on'),
      ),
      confirmButton(
        { label: 'Reboot', question: 'Reboot the robot?', yes: 'Reboot' },
        () => void act('reboot', {}, 'The robot reboots'),
      ),
      confirmButton(
        { label: 'Shut down', question: 'Shut the robot down?', yes: 'Shut down' },
        () => void act('shutdown', {}, 'The robot shuts down'),
      ),
      button('Press pause', () => void session.input('press pause'), {
        title: 'The button on the back: the motors lose power',
      }),
    ),
  );
}

function makeController(session: Session): HTMLElement {
  const note = el('p', { class: 'hint' }, 'An image CONTROLL.BIN. It runs after the next reboot; the old one is kept as CONTROLL.OLD.');
  const upload = makeUpload(session, {
    label: 'Upload controller',
    accept: '.bin,.BIN',
    kind: 'controller',
    onDone: (name) => setText(note, `${name} is on the stick. Reboot to run it.`),
  });
  return section('Controller', el('div', { class: 'row' }, upload), note);
}

export function makeRobot(session: Session): HTMLElement {
  return el(
    'div',
    { class: 'robot-panel' },
    ...makeDevices(session),
    makeBattery(session),
    makePower(session),
    makeController(session),
  );
}
