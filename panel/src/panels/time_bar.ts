// The time bar: pause, steps, the rate of the run, and going back.
import { button, el, setDisabled, setText } from '../dom';
import { clockTime, fixed } from '../format';
import { LastValue } from '../last_value';
import type { Clock, Rewind } from '../protocol';
import type { Session } from '../session';

const RATES = [0.1, 0.25, 0.5, 1, 2, 5, 10, 0];
const BACK_S = 5;

function rateName(rate: number): string {
  return rate === 0 ? 'max' : `${rate}×`;
}

function whyNoRewind(clock: Clock | null): string {
  if (clock === null) return 'no connection';
  if (clock.rewind === undefined) return 'this run keeps no past moments';
  return clock.rewind.why || 'no moment of the past is kept yet';
}

class TimeBar {
  readonly element = el('section', { class: 'time', 'aria-label': 'Time' });
  private readonly play: HTMLButtonElement;
  private readonly steps: HTMLButtonElement[];
  private readonly now = el('output', { class: 'now', 'aria-label': 'Virtual time' }, '0:00.000');
  private readonly speed = el('span', { class: 'speed' });
  private readonly rate = el('select', { 'aria-label': 'Rate: virtual seconds per second' });
  private readonly past = el('input', {
    type: 'range',
    step: 0.008,
    min: 0,
    max: 1,
    value: 1,
    'aria-label': 'Moment shown',
  });
  private readonly from = el('span', { class: 'end' });
  private readonly to = el('span', { class: 'end' });
  private readonly back: HTMLButtonElement;
  private readonly present: HTMLButtonElement;
  private readonly goOn: HTMLButtonElement;
  private readonly memory = el('span', { class: 'memory' });
  private isDragged = false;
  private readonly seek: LastValue<number>;

  constructor(private readonly session: Session) {
    this.seek = new LastValue<number>(80, (time) => this.goTo(time));
    this.play = button('Pause', () => this.togglePause(), { class: 'play', title: 'Key: P' });
    const step = (label: string, kind: string, title: string) =>
      button(label, () => void session.setClock({ step: kind, count: 1 }), { title });
    this.steps = [
      step('Frame', 'frame', 'Goes on for one frame of 8 ms. Key: full stop'),
      step('Message', 'message', 'Goes on until the next message has been handled'),
      step('Vector', 'vector', 'Goes on until the next sensor vector has been handled'),
    ];
    this.back = button(`−${BACK_S} s`, () => this.goBack(), {
      class: 'back',
      title: 'Shows the moment five seconds ago. Key: B',
      'aria-label': 'Back five seconds',
    });
    this.present = button('Present', () => void session.rewind({ present: true }), {
      title: 'Shows the newest moment again',
    });
    this.goOn = button('Go on from here', () => void this.branch(), {
      class: 'branch',
      title: 'A new run begins with the moment shown',
    });
    this.rate.append(...RATES.map((rate) => el('option', { value: rate }, rateName(rate))));
    this.rate.value = '1';
    this.build();
    session.on('clock', (clock) => this.show(clock));
    session.on('link', () => this.show(session.clock));
    // Drops the moment of the slider that waits, because it would be shown after what the person
    // has chosen later.
    session.on('rewind', () => this.seek.drop());
    session.on('newRun', () => {
      this.seek.drop();
      this.show(null);
    });
    this.show(null);
    document.addEventListener('keydown', (event) => this.onKey(event));
  }

  private build(): void {
    this.rate.addEventListener('change', () => {
      void this.session.setClock({ rate: Number(this.rate.value) });
      this.rate.blur();
    });
    this.past.addEventListener('input', () => {
      this.isDragged = true;
      this.seek.set(Number(this.past.value));
    });
    this.past.addEventListener('change', () => {
      this.isDragged = false;
    });
    this.element.append(
      el(
        'div',
        { class: 'transport' },
        el('div', { class: 'group run' }, this.play, this.now),
        el('div', { class: 'group steps', role: 'group', 'aria-label': 'One step' }, ...this.steps),
        el('label', { class: 'group rate' }, el('span', { class: 'caption' }, 'Rate'), this.rate, this.speed),
      ),
      el('div', { class: 'group past' }, this.back, this.from, this.past, this.to, this.present, this.goOn),
      this.memory,
    );
  }

  private get isPaused(): boolean {
    return this.session.clock?.paused === true || this.shows !== null;
  }

  // Returns the moment of the past that the page shows; null means the present.
  private get shows(): number | null {
    return this.session.clock?.rewind?.shows_s ?? null;
  }

  private togglePause(): void {
    const clock = this.session.clock;
    if (this.shows !== null) {
      this.session.bad('A moment of the past is shown: go to the present, or go on from here.');
    } else if (clock !== null) {
      void this.session.setClock({ pause: !clock.paused });
    }
  }

  // Shows the moment `time`. A moment in the future is possible only in a recording.
  private async goTo(time: number): Promise<void> {
    const { session } = this;
    const newest = session.clock?.rewind?.to_s ?? 0;
    if (session.isRecording && time > newest) {
      await session.setClock({ to_s: time });
    } else {
      await session.rewind({ to_s: time });
    }
  }

  private goBack(): void {
    if (!this.session.canRewind) {
      this.session.bad(`Cannot go back: ${whyNoRewind(this.session.clock)}`);
      return;
    }
    const rewind = this.session.clock?.rewind;
    const from = rewind?.from_s ?? 0;
    const now = this.shows ?? rewind?.to_s ?? 0;
    // Goes to the oldest moment if less than five seconds can be rewound.
    void this.session.rewind(now - BACK_S < from ? { to_s: from } : { back_s: BACK_S });
  }

  private async branch(): Promise<void> {
    this.seek.drop();
    const answer = await this.session.tell<{ run: string }>({ do: 'branch' }, 'Going on from here');
    if (answer === null) return;
    if (!this.session.isRecording) this.session.good(`The new run ${answer.run} goes on from here.`);
    this.session.emit('branched', answer.run);
  }

  private show(clock: Clock | null): void {
    const isOpen = this.session.link === 'open' && clock !== null;
    const shows = this.shows;
    setText(this.goOn, this.session.isRecording ? 'Play from here' : 'Go on from here');
    const playText = this.isPaused ? '▶ Run' : '❚❚ Pause';
    setText(this.play, playText);
    this.play.classList.toggle('paused', this.isPaused);
    setDisabled(this.play, !isOpen || shows !== null);
    for (const step of this.steps) setDisabled(step, !isOpen || shows !== null);
    setDisabled(this.rate, !isOpen);
    setText(this.now, clockTime(shows ?? clock?.time_s ?? 0));
    this.now.classList.toggle('past', shows !== null);
    setText(this.speed, clock === null || this.isPaused ? '' : `runs ${fixed(clock.speed, 2)}×`);
    if (clock !== null && document.activeElement !== this.rate) this.showRate(clock.rate);
    this.showPast(clock, isOpen);
  }

  private showRate(rate: number): void {
    const value = String(rate);
    if (this.rate.value === value) return;
    if (![...this.rate.options].some((each) => each.value === value))
      this.rate.append(el('option', { value }, rateName(rate)));
    this.rate.value = value;
  }

  private showPast(clock: Clock | null, isOpen: boolean): void {
    const rewind: Rewind | undefined = clock?.rewind;
    const isPossible = isOpen && rewind?.possible === true;
    const isPast = this.shows !== null;
    setDisabled(this.past, !isPossible);
    this.back.classList.toggle('unavailable', !isPossible);
    this.back.setAttribute('aria-disabled', isPossible ? 'false' : 'true');
    setDisabled(this.present, !isPossible || !isPast);
    setDisabled(this.goOn, !isPossible || !isPast);
    this.element.classList.toggle('no-past', !isPossible);
    if (rewind === undefined || !isPossible) {
      setText(this.from, '');
      setText(this.to, '');
      setText(this.memory, isOpen ? `No way back: ${whyNoRewind(clock)}` : '');
      return;
    }
    const from = rewind.from_s ?? 0;
    const to = rewind.to_s ?? clock?.time_s ?? 0;
    if (!this.isDragged) {
      this.past.min = String(from);
      this.past.max = String(Math.max(from + 0.008, to, clock?.length_s ?? 0));
      this.past.value = String(this.shows ?? to);
    }
    const value = Number(this.past.value);
    const end = Number(this.past.max);
    this.past.style.setProperty('--at', String(end > from ? (value - from) / (end - from) : 1));
    this.past.setAttribute('aria-valuetext', clockTime(value));
    const length = clock?.length_s;
    setText(this.from, length === undefined ? `−${Math.max(0, Math.round(to - from))} s` : clockTime(from));
    setText(this.to, clockTime(length ?? to));
    const memory = rewind.memory_mb === undefined ? '' : `, ${Math.round(rewind.memory_mb)} MB`;
    const over = clock?.over ? `${clock.over} · ` : '';
    setText(this.memory, `${over}${rewind.checkpoints ?? 0} checkpoints${memory}`);
  }

  private onKey(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (target.closest('input:not([type=range]), select, textarea')) return;
    const actions: Record<string, () => void> = {
      p: () => this.togglePause(),
      b: () => this.goBack(),
      '.': () => void this.session.setClock({ step: 'frame', count: 1 }),
    };
    const action = actions[event.key];
    if (action === undefined) return;
    event.preventDefault();
    action();
  }
}

export function makeTimeBar(session: Session): HTMLElement {
  return new TimeBar(session).element;
}
