// The panel of joints: a slider for each joint, with the target as its handle and the measured
// angle as a mark.
import { button, el, setClass, setDisabled, setText } from '../dom';
import { degrees, UNKNOWN } from '../format';
import { LastValue } from '../last_value';
import type { Answer, JointData, RemoteJoint, RobotValues } from '../protocol';
import type { Session } from '../session';
import { byError, errorOf, JointGoal } from './joint_goal';

const MOVE_PERIOD_MS = 50; // at most 20 commands a second
const LOCKING_STATES = ['mtn', 'prepare-mtn'];
// The order by error changes at most once in this time, so that a person can read it.
const SORT_PERIOD_MS = 600;

function lockReason(isRecording: boolean, isPast: boolean, motion: string, plays: boolean): string {
  if (isRecording) return 'Locked: this is a recording.';
  if (isPast) return 'Locked: a moment of the past is shown.';
  if (motion !== '') return `Locked: the robot plays ${motion}. Stop it to move joints.`;
  if (plays) return 'Locked: a motion plays. Stop it to move joints.';
  return 'Locked: the dog goes to the first key frame of a motion.';
}

class JointRow {
  readonly element = el('div', { class: 'joint', role: 'group' });
  readonly slider: HTMLInputElement;
  private readonly target = el('span', { class: 'value target' });
  private readonly measured = el('span', { class: 'value measured' });
  private readonly flag = el('span', { class: 'flag' });
  private readonly track = el('div', { class: 'track' });
  private readonly goal = new JointGoal();
  private isHeld = false;

  constructor(session: Session, joint: JointData, index: number) {
    const title = joint.title || joint.name;
    this.slider = el('input', {
      type: 'range',
      min: joint.min_deg,
      max: joint.max_deg,
      step: 0.1,
      value: Math.max(joint.min_deg, Math.min(joint.max_deg, 0)),
      'aria-label': title,
    });
    const move = new LastValue<number>(MOVE_PERIOD_MS, (deg) =>
      session.rc('move', { joint: index, deg }, `Move ${title}`),
    );
    this.slider.addEventListener('input', () => {
      const deg = Number(this.slider.value);
      this.goal.set(deg, performance.now());
      this.showTarget(deg);
      move.set(deg);
    });
    this.slider.addEventListener('pointerdown', () => (this.isHeld = true));
    for (const name of ['pointerup', 'pointercancel', 'lostpointercapture'])
      this.slider.addEventListener(name, () => (this.isHeld = false));
    this.slider.addEventListener('dblclick', () => this.slider.blur());
    this.track.style.setProperty('--zero', String(fraction(joint, 0)));
    this.track.append(el('i', { class: 'rail' }), el('i', { class: 'error' }), el('i', { class: 'mark' }), el('i', { class: 'other' }), this.slider);
    this.element.setAttribute('aria-label', title);
    this.element.append(
      el('span', { class: 'name', title: `${title}\n${joint.locator}\n${joint.min_deg}° to ${joint.max_deg}°` }, joint.name),
      this.track,
      this.target,
      this.measured,
      this.flag,
    );
    this.joint = joint;
  }

  private readonly joint: JointData;

  lock(isLocked: boolean): void {
    setDisabled(this.slider, isLocked);
    if (isLocked) this.goal.clear();
  }

  // Shows the position of this joint at the second robot; null: no second robot is connected.
  showOther(deg: number | null): void {
    setClass(this.track, 'paired', deg !== null);
    if (deg !== null) this.track.style.setProperty('--other', fraction(this.joint, deg).toFixed(4));
  }

  show(pair: [number | null, number | null] | undefined, gain: number | undefined, isLargest: boolean): void {
    const shown = this.isHeld ? null : this.goal.show(pair?.[0] ?? null, performance.now());
    if (!this.isHeld) {
      if (shown !== null && this.slider.value !== String(shown)) this.slider.value = String(shown);
      this.showTarget(shown);
    }
    const measured = pair?.[1] ?? null;
    setText(this.measured, degrees(measured));
    const at = measured === null ? 0 : fraction(this.joint, measured);
    const want = fraction(this.joint, Number(this.slider.value));
    this.track.style.setProperty('--at', at.toFixed(4));
    this.track.style.setProperty('--want', want.toFixed(4));
    setClass(this.track, 'unknown', measured === null);
    setClass(this.element, 'largest', isLargest);
    const error = errorOf(pair);
    setText(this.flag, gain === 0 ? 'no power' : error === null ? '' : `${isLargest ? '▲ ' : ''}${degrees(error)}`);
    this.flag.title = isLargest ? 'The largest error of all joints' : 'Error: distance between target and measured';
    setClass(this.element, 'limp', gain === 0);
    this.slider.setAttribute('aria-valuetext', `target ${this.target.textContent}, measured ${degrees(measured)}`);
  }

  private showTarget(deg: number | null): void {
    setText(this.target, deg === null ? 'none' : degrees(deg));
  }
}

function fraction(joint: JointData, deg: number): number {
  const range = joint.max_deg - joint.min_deg;
  return range > 0 ? Math.min(1, Math.max(0, (deg - joint.min_deg) / range)) : 0;
}

// A slider for the speed limit, or the acceleration limit, of all joints.
class LimitSlider {
  readonly element: HTMLElement;
  private readonly slider = el('input', { type: 'range', min: 1, max: 100, step: 1, value: 100 });
  private readonly text = el('span', { class: 'value' });
  private maxima: number[] = [];

  constructor(
    private readonly session: Session,
    private readonly call: 'speed' | 'accel',
    private readonly title: string,
    private readonly unit: string,
  ) {
    this.slider.setAttribute('aria-label', `${title} of all joints`);
    this.slider.addEventListener('input', () => this.showText());
    this.slider.addEventListener('change', () => void this.send());
    this.element = el('label', { class: 'limit' }, el('span', { class: 'name' }, title), this.slider, this.text);
  }

  setJoints(joints: JointData[]): void {
    this.maxima = joints.map((each) => (this.call === 'speed' ? each.max_speed : each.max_accel));
    const max = Math.ceil(Math.max(1, ...this.maxima));
    this.slider.max = String(max);
    this.slider.value = String(max);
    this.showText();
  }

  // Shows the largest of the values that are in force at the robot.
  setInForce(values: number[]): void {
    if (values.length === 0) return;
    this.slider.value = String(Math.round(Math.max(...values)));
    this.showText();
  }

  private showText(): void {
    const value = Number(this.slider.value);
    const capped = this.maxima.filter((max) => max < value).length;
    setText(this.text, `${value} ${this.unit}${capped > 0 ? ` · ${capped} at their max` : ''}`);
  }

  private async send(): Promise<void> {
    const value = Number(this.slider.value);
    for (let joint = 0; joint < this.maxima.length; ++joint) {
      const capped = Math.min(value, this.maxima[joint] ?? value);
      const answer = await this.session.rc(this.call, { joint, value: capped }, this.title);
      if (answer === null) return;
    }
    this.session.good(`${this.title} of all joints: at most ${value} ${this.unit}`);
  }
}

class Joints {
  readonly element = el('div', { class: 'joints' });
  private readonly list = el('div', { class: 'joint-list' });
  private readonly largest = button('', () => this.showLargest(), { class: 'largest-error quiet' });
  private readonly sort: HTMLButtonElement;
  private readonly lockText = el('p', { class: 'lock', hidden: true });
  private readonly speed: LimitSlider;
  private readonly accel: LimitSlider;
  private rows: JointRow[] = [];
  private isSorted = false;
  private sortedAt = 0;
  private largestIndex = -1;
  private connected = '';
  private wasPast = false;

  constructor(private readonly session: Session) {
    this.speed = new LimitSlider(session, 'speed', 'Speed', '°/s');
    this.accel = new LimitSlider(session, 'accel', 'Acceleration', '°/s²');
    this.sort = button('Sort by error', () => this.toggleSort(), { 'aria-pressed': 'false' });
    this.element.append(
      el('div', { class: 'bar' }, this.largest, this.sort),
      this.lockText,
      el(
        'div',
        { class: 'joint joint-head', 'aria-hidden': true },
        ...['joint', '', 'target', 'measured', 'error'].map((each) => el('span', { class: each }, each)),
      ),
      this.list,
      el('div', { class: 'limits' }, this.speed.element, this.accel.element),
    );
    this.list.addEventListener('change', () => void this.connect());
    session.on('scene', () => this.build());
    session.on('robot', () => this.build());
    session.on('newRun', () => {
      this.connected = '';
      this.lockAll();
    });
    session.on('values', () => this.reshow());
    let isPaired = false;
    session.on('pair', (pair) => {
      if (pair.isConnected && !isPaired && pair.answer !== null) this.showLimits(pair.answer.joints);
      isPaired = pair.isConnected;
      this.rows.forEach((row, i) => row.showOther(isPaired ? (pair.status?.deg?.[i] ?? null) : null));
    });
    // Updates the lock with events of the clock, too, because no values come while the run is
    // paused.
    session.on('clock', () => {
      if (this.isPast !== this.wasPast) this.reshow();
    });
    window.addEventListener('panel-shown', () => this.reshow());
  }

  private get isPast(): boolean {
    return (this.session.clock?.rewind?.shows_s ?? null) !== null;
  }

  private reshow(): void {
    const robot = this.session.values?.robots[this.session.robot];
    if (robot !== undefined) this.show(robot);
  }

  private build(): void {
    const joints = this.session.scene?.robots[this.session.robot]?.joints ?? [];
    this.rows = joints.map((joint, i) => new JointRow(this.session, joint, i));
    this.list.replaceChildren(...this.rows.map((each) => each.element));
    this.lockAll();
    this.speed.setJoints(joints);
    this.accel.setJoints(joints);
    this.reshow();
  }

  // Locks the sliders until the first values of the run come: before them, the page does not know
  // whether the joints can be moved, and the text above the sliders can still come or go.
  private lockAll(): void {
    this.rows.forEach((row) => row.lock(true));
  }

  // Reads the limits in force when a person has used the remote control for the first time.
  private async connect(): Promise<void> {
    const key = `${this.session.run}/${this.session.robot}`;
    if (this.connected === key) return;
    this.connected = key;
    const answer = await this.session.rc<{ joints: RemoteJoint[] } & Answer>('connect', {}, 'Remote control');
    if (answer !== null) this.showLimits(answer.joints);
  }

  private showLimits(joints: RemoteJoint[]): void {
    this.speed.setInForce(joints.map((each) => each.speed));
    this.accel.setInForce(joints.map((each) => each.accel));
  }

  private show(robot: RobotValues): void {
    if (this.element.offsetParent === null) return;
    const { motion } = this.session.pair;
    const otherState = this.session.pair.status?.robot_state ?? '';
    const isPlaying = [robot.state, otherState].some((state) => LOCKING_STATES.includes(state));
    const { isPast } = this;
    const { isRecording } = this.session;
    this.wasPast = isPast;
    this.lockText.hidden = !isPlaying && !isPast && !isRecording;
    setText(
      this.lockText,
      lockReason(isRecording, isPast, motion, [robot.state, otherState].includes('mtn')),
    );
    const order = byError(robot.joints);
    const first = order[0] ?? -1;
    const error = first < 0 ? null : errorOf(robot.joints[first]);
    this.largestIndex = error === null ? -1 : first;
    const name = this.session.scene?.robots[this.session.robot]?.joints[first]?.name ?? '';
    setText(
      this.largest,
      error === null ? `Largest error: ${UNKNOWN}` : `▲ Largest error: ${name} ${degrees(error)}`,
    );
    this.rows.forEach((row, i) => {
      row.lock(isPlaying || isPast || isRecording);
      row.show(robot.joints[i], robot.gains?.[i], i === this.largestIndex);
    });
    if (this.isSorted) this.reorder(order);
  }

  private reorder(order: number[]): void {
    const now = performance.now();
    if (now - this.sortedAt < SORT_PERIOD_MS || this.list.contains(document.activeElement)) return;
    this.sortedAt = now;
    order.forEach((index, place) => {
      const element = this.rows[index]?.element;
      if (element !== undefined && this.list.children[place] !== element)
        this.list.insertBefore(element, this.list.children[place] ?? null);
    });
  }

  private toggleSort(): void {
    this.isSorted = !this.isSorted;
    this.sortedAt = 0;
    this.sort.setAttribute('aria-pressed', String(this.isSorted));
    if (!this.isSorted) this.list.replaceChildren(...this.rows.map((each) => each.element));
    else this.list.scrollTop = 0;
  }

  private showLargest(): void {
    const row = this.rows[this.largestIndex];
    row?.element.scrollIntoView({ block: 'nearest' });
    row?.slider.focus();
  }
}

export function makeJoints(session: Session): HTMLElement {
  return new Joints(session).element;
}
