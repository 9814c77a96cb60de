// The bar at the top of the page: the run, the robot and its state.
import { button, el, setClass, setText } from './dom';
import { switchTheme, isDark, onTheme } from './theme';
import type { Session } from './session';

const linkTexts = {
  connecting: 'Connecting',
  open: 'Connected',
  lost: 'Connection lost, trying again',
  ended: 'Run has ended',
  refused: 'No connection',
} as const;

function makeRunChoice(session: Session, join: (run: string) => void): HTMLElement {
  const choice = el('select', { class: 'run', 'aria-label': 'Run' });
  choice.addEventListener('change', () => join(choice.value));
  let shown = '';
  session.on('runs', (runs) => {
    const current = session.run === '' ? runs.own : session.run;
    const entries = [...(runs.runs ?? [])];
    if (!entries.some((each) => each.run === current))
      entries.push({ name: current, process: 0, run: current });
    const state = JSON.stringify([entries.map((each) => [each.run, each.model]), current]);
    if (state === shown || document.activeElement === choice) return;
    shown = state;
    choice.replaceChildren(
      ...entries.map((each) =>
        el(
          'option',
          { value: each.run },
          each.process === 0
            ? `${each.name} (ended)`
            : `${each.name} · ${each.process}${each.model ? ` · ${each.model}` : ''}`,
        ),
      ),
    );
    choice.value = current;
  });
  return choice;
}

function makeRobotChoice(session: Session): HTMLElement {
  const choice = el('select', { class: 'robot', 'aria-label': 'Robot', hidden: true });
  choice.addEventListener('change', () => session.chooseRobot(Number(choice.value)));
  session.on('scene', (scene) => {
    choice.hidden = scene.robots.length < 2;
    choice.replaceChildren(
      ...scene.robots.map((_, i) => el('option', { value: i }, `Robot ${i + 1}`)),
    );
    choice.value = String(session.robot);
  });
  session.on('robot', (robot) => {
    choice.value = String(robot);
  });
  return choice;
}

// Makes the chips in the bar for the most important facts: the state of the dog, its battery, and
// objects that wait.
function makeChips(session: Session, show: (panel: string) => void): HTMLElement[] {
  const state = el('span', { class: 'chip', title: 'State of JointMover' }, '–');
  const motors = el('span', { class: 'chip optional' }, '');
  const battery = el('span', { class: 'chip optional' }, '');
  session.on('values', (values) => {
    const robot = values.robots[session.robot];
    if (robot === undefined) return;
    const boots = robot.boots_at_s ?? null;
    const left = boots === null ? '' : `, boots in ${Math.ceil(boots - values.time_s)} s`;
    setText(state, robot.state === '' ? 'state unknown' : robot.state + left);
    setText(motors, robot.motors === false ? '○ motors off' : '● motors on');
    const percent = robot.battery?.percent;
    const sign = robot.battery?.charging ? ' charging' : '';
    setText(battery, percent === undefined ? 'battery unknown' : `battery ${percent}%${sign}`);
    setClass(battery, 'warn', percent !== undefined && percent < 15);
  });
  session.on('newRun', () => {
    setText(state, '–');
    setText(motors, '');
    setText(battery, '');
  });
  const waits = button('', () => show('graph'), { class: 'chip warn', hidden: true });
  session.on('graph', (graph) => {
    const names = graph.objects.filter((each) => each.waits_for).map((each) => each.name);
    waits.hidden = names.length === 0;
    setText(waits, names.length === 1 ? `◔ ${names[0]} waits` : `◔ ${names.length} objects wait`);
  });
  const pair = button('', () => show('both'), { class: 'chip pair', hidden: true });
  session.on('pair', ({ isConnected, simulation, follow, status }) => {
    pair.hidden = !isConnected;
    const lag = status?.lag_ms ?? null;
    const where = simulation ? 'both dogs' : 'robot only';
    const who = follow === 'none' ? where : `${follow} follows`;
    setText(pair, `⇄ ${lag === null ? who : `lag ${lag} ms`}`);
    pair.title = lag === null ? who : `${who}, lag ${lag} ms`;
    setClass(pair, 'warn', !simulation);
  });
  return [state, motors, battery, pair, waits];
}

export function makeHeader(
  session: Session,
  join: (run: string) => void,
  show: (panel: string) => void,
): HTMLElement {
  const link = el('span', { class: 'link' }, el('i', { 'aria-hidden': true }), el('span', {}, ''));
  session.on('link', ({ state, why }) => {
    link.dataset['state'] = state;
    setText(link.lastElementChild as Element, linkTexts[state]);
    link.title = why;
  });
  const theme = button('', switchTheme, { class: 'quiet theme' });
  const showTheme = () => {
    theme.textContent = isDark() ? 'Light' : 'Dark';
    theme.setAttribute('aria-label', isDark() ? 'Switch to light colours' : 'Switch to dark colours');
  };
  onTheme(showTheme);
  showTheme();
  return el(
    'header',
    { class: 'top' },
    el('h1', {}, el('b', {}, 'openr'), ' panel'),
    makeRunChoice(session, join),
    makeRobotChoice(session),
    link,
    el('div', { class: 'chips' }, ...makeChips(session, show)),
    theme,
  );
}

// Makes the bar across the page that says why the page shows no new values.
export function makeLinkBanner(session: Session, join: (run: string) => void): HTMLElement {
  const text = el('span', {});
  const next = el('span', { class: 'next' });
  const banner = el('div', { class: 'banner', role: 'alert', hidden: true }, text, next);
  const show = () => {
    const others = (session.runs?.runs ?? []).filter(
      (each) => each.run !== (session.run || session.runs?.own),
    );
    next.replaceChildren(
      ...(session.link === 'ended'
        ? others.slice(0, 4).map((each) => button(`Show ${each.run}`, () => join(each.run)))
        : []),
    );
  };
  session.on('link', ({ state, why }) => {
    banner.hidden = state === 'open' || state === 'connecting';
    document.body.classList.toggle('stale', !banner.hidden);
    const more = why === '' || why.toLowerCase().includes('has ended') ? '' : ` (${why})`;
    setText(
      text,
      state === 'ended'
        ? `The run has ended${more}. What you see is its last moment.`
        : state === 'refused'
          ? why
          : `The connection to the run was lost${more}. The page tries again.`,
    );
    show();
  });
  return banner;
}
