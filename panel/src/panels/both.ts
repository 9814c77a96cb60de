// The panel "Both dogs": connects a second robot, has the box "simulation", and lets one dog follow
// the other.
import { button, el, setClass, setDisabled, setText } from '../dom';
import { degrees, UNKNOWN } from '../format';
import type { Follow } from '../pair';
import type { Session } from '../session';

const PERIODS_MS = [32, 64, 128, 256];
const FOLLOW: [Follow, string][] = [
  ['none', 'No: each by itself'],
  ['simulation', 'Simulation follows robot'],
  ['robot', 'Robot follows simulation'],
];

function milliseconds(value: number | null | undefined): string {
  return value === null || value === undefined ? UNKNOWN : `${Math.round(value)} ms`;
}

// Returns the joint at which two poses differ most, with the difference; -1 if there is no such
// joint.
export function largestDifference(a: (number | null)[], b: number[]): { joint: number; deg: number } {
  let largest = { joint: -1, deg: 0 };
  a.forEach((mine, joint) => {
    const other = b[joint];
    if (mine === null || other === undefined) return;
    const deg = Math.abs(mine - other);
    if (largest.joint < 0 || deg > largest.deg) largest = { joint, deg };
  });
  return largest;
}

class Both {
  readonly element = el('div', { class: 'both' });
  private readonly address = el('input', {
    type: 'text',
    class: 'address',
    placeholder: '127.0.0.1:54001',
    maxlength: 260,
    spellcheck: 'false',
    autocomplete: 'off',
    'aria-label': 'Address of the second robot',
  });
  private readonly period = el('select', { 'aria-label': 'Time between two sensor values' });
  private readonly connect: HTMLButtonElement;
  private readonly simulation = el('input', { type: 'checkbox', checked: true, disabled: true });
  private readonly follow = el('select', { 'aria-label': 'Follow' });
  private readonly boxHint = el('p', { class: 'hint' });
  private readonly why = el('p', { class: 'lost', role: 'status', hidden: true });
  private readonly rows = new Map<string, HTMLElement>();
  private readonly facts = el('dl', { class: 'facts', hidden: true });

  constructor(private readonly session: Session) {
    this.connect = button('Connect', () => this.toggle(), { class: 'primary' });
    this.period.append(...PERIODS_MS.map((ms) => el('option', { value: ms }, `${ms} ms`)));
    this.follow.append(...FOLLOW.map(([value, text]) => el('option', { value }, text)));
    this.simulation.addEventListener('change', () => this.wish());
    this.follow.addEventListener('change', () => this.wish());
    this.address.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.toggle();
    });
    for (const name of ['Robot', 'Lag of the pose', 'Round trip', 'Largest difference', 'Motion', 'Refused'])
      this.addFact(name);
    this.element.append(
      el('div', { class: 'row connect' }, this.address, this.connect),
      this.why,
      el('label', { class: 'box' }, this.simulation, el('span', {}, 'Simulation')),
      this.boxHint,
      el('label', { class: 'choice' }, el('span', { class: 'caption' }, 'Follow'), this.follow),
      el('label', { class: 'choice' }, el('span', { class: 'caption' }, 'Every'), this.period),
      this.facts,
      el(
        'p',
        { class: 'hint note' },
        'A robot, or another openr run, at its remote control (HOST:PORT). While it is connected, the run goes on in ' +
          'real time and cannot go back. Tried with a second openr run; nobody has tried it with a real dog.',
      ),
    );
    window.addEventListener('panel-shown', () => this.showFacts());
    session.on('pair', () => this.show());
    session.on('values', () => this.showFacts());
    this.show();
  }

  private addFact(name: string): void {
    const value = el('dd', {}, UNKNOWN);
    this.rows.set(name, value);
    this.facts.append(el('dt', {}, name), value);
  }

  private fact(name: string, text: string): void {
    const row = this.rows.get(name);
    if (row !== undefined) setText(row, text);
  }

  private toggle(): void {
    const { pair } = this.session;
    if (pair.isConnected) void pair.disconnect();
    else if (pair.phase === 'none') void pair.connect(this.address.value.trim(), Number(this.period.value));
  }

  private wish(): void {
    void this.session.pair.wish(this.simulation.checked, this.follow.value as Follow);
  }

  private show(): void {
    const { pair } = this.session;
    const { isConnected } = pair;
    const isFree = pair.phase === 'none';
    setText(this.connect, isConnected ? 'Disconnect' : isFree ? 'Connect' : 'Wait');
    setClass(this.connect, 'primary', isFree);
    setDisabled(this.connect, !isFree && !isConnected);
    setDisabled(this.address, !isFree);
    setDisabled(this.period, !isFree);
    setDisabled(this.simulation, !isConnected);
    setDisabled(this.follow, !isConnected);
    this.simulation.checked = pair.wanted.simulation;
    this.follow.value = pair.wanted.follow;
    for (const option of this.follow.options) option.disabled = option.value === 'simulation' && !pair.wanted.simulation;
    setText(
      this.boxHint,
      !isConnected
        ? 'Without a second robot the simulation is always controlled.'
        : pair.follow !== 'none'
          ? `Joint commands go to the ${pair.follow === 'robot' ? 'simulation' : 'robot'}, which leads.`
          : pair.simulation
            ? 'Commands go to both dogs.'
            : 'Commands go to the robot only.',
    );
    this.why.hidden = pair.why === '';
    setText(this.why, pair.why === '' ? '' : `Not connected: ${pair.why}`);
    this.facts.hidden = !isConnected;
    this.showFacts();
  }

  private showFacts(): void {
    const { pair } = this.session;
    if (!pair.isConnected || this.element.offsetParent === null) return;
    const { status } = pair;
    const joints = this.session.scene?.robots[this.session.robot]?.joints ?? [];
    const measured = this.session.values?.robots[this.session.robot]?.joints.map((each) => each[1]) ?? [];
    const largest = largestDifference(measured, status?.deg ?? []);
    const name = joints[largest.joint]?.name ?? '';
    const moves = pair.follow !== 'none' || pair.motion !== '';
    this.fact('Robot', `${pair.answer?.model ?? ''} ${status?.robot_state ?? ''}`.trim());
    this.fact(
      'Lag of the pose',
      status?.lag_ms !== null && status?.lag_ms !== undefined
        ? milliseconds(status.lag_ms)
        : moves
          ? `${UNKNOWN} (needs movement)`
          : `${UNKNOWN} (no dog follows)`,
    );
    this.fact('Round trip', `robot ${milliseconds(status?.round_trip_ms)}, run ${milliseconds(status?.run_round_trip_ms)}`);
    this.fact('Largest difference', largest.joint < 0 ? UNKNOWN : `${name} ${degrees(largest.deg)}`);
    this.fact(
      'Motion',
      pair.motion === '' ? 'none' : `${pair.motion}, key frame ${status?.key_frame ?? 0}${pair.simulation ? ', on both' : ''}`,
    );
    const refusals = Object.entries(status?.refusal ?? {}).filter(([, text]) => text !== '');
    this.fact('Refused', refusals.length === 0 ? 'nothing' : refusals.map((each) => each.join(': ')).join('; '));
  }
}

export function makeBoth(session: Session): HTMLElement {
  return new Both(session).element;
}
