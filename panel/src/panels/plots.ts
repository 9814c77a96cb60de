// The panel of plots: curves of chosen joints and sensors over the last minute.
import { button, el, saveFile, setText } from '../dom';
import type { Session } from '../session';
import { colourOf, onTheme } from '../theme';
import { csvOf, History, seriesOf, WINDOW_S, type Series } from './plot_data';
import { drawPlot, type PlotRequest } from './plot_picture';

const SPANS_S = [5, 10, 20, 60];
const SERIES_MAX = 12;
const FIRST_SERIES = ['joint:neck_pan:commanded', 'joint:neck_pan:measured'];

class Plots {
  readonly element = el('div', { class: 'plots' });
  private readonly history = new History();
  private readonly picture = el('div', { class: 'plot-picture', tabindex: 0 });
  private readonly add = el('select', { 'aria-label': 'Add a series to the plot' });
  private readonly chips = el('span', { class: 'series' });
  private readonly span = el('select', { 'aria-label': 'Seconds shown' });
  private readonly hold: HTMLButtonElement;
  private readonly scroll = el('input', { type: 'range', min: 0, max: 1, step: 0.01, value: 1, 'aria-label': 'Part of the last minute' });
  private known: Series[] = [];
  private chosen: string[] = [...FIRST_SERIES];
  private heldAt: number | null = null; // time at the right end of a paused plot; null: the plot
                                        // goes on
  private isDirty = false;

  constructor(private readonly session: Session) {
    this.hold = button('Pause', () => this.setHeld(this.heldAt === null ? (this.history.newest ?? 0) : null), {
      'aria-pressed': 'false',
    });
    this.span.append(...SPANS_S.map((each) => el('option', { value: each }, `${each} s`)));
    this.span.value = '20';
    this.span.addEventListener('change', () => this.changed());
    this.add.addEventListener('change', () => this.choose(this.add.value));
    this.scroll.addEventListener('input', () => this.scrollTo(Number(this.scroll.value)));
    this.listenToDrags();
    this.element.append(
      el('div', { class: 'bar' }, this.add, this.span, this.hold, this.scroll, el('span', { class: 'spring' }),
        button('Save SVG', () => this.saveSvg()), button('Save CSV', () => this.saveCsv())),
      this.chips,
      this.picture,
    );
    session.on('scene', () => this.rebuild());
    session.on('robot', () => this.rebuild());
    session.on('newRun', () => {
      this.history.clear();
      this.setHeld(null);
    });
    session.on('values', (values) => {
      if (this.cursor === null) this.history.add(values);
      this.changed();
    });
    onTheme(() => this.changed());
    window.addEventListener('panel-shown', () => this.changed());
    new ResizeObserver(() => this.changed()).observe(this.picture);
  }

  private get cursor(): number | null {
    return this.session.clock?.rewind?.shows_s ?? null;
  }

  private get series(): Series[] {
    return this.chosen.flatMap((id) => this.known.filter((each) => each.id === id));
  }

  private rebuild(): void {
    if (this.session.scene === null) return;
    const groups = seriesOf(this.session.scene, this.session.robot);
    this.known = groups.flatMap((each) => each.series);
    this.add.replaceChildren(
      el('option', { value: '' }, 'Add series'),
      ...groups.map(({ group, series }) =>
        el('optgroup', { label: group }, ...this.options(series)),
      ),
    );
    this.showChips();
  }

  private options(series: Series[]): HTMLOptionElement[] {
    const options: HTMLOptionElement[] = [];
    for (const each of series) {
      const [kind, name, part] = each.id.split(':');
      if (kind === 'joint' && part === 'commanded')
        options.push(el('option', { value: `joint:${name}` }, `${name}, both`));
      options.push(el('option', { value: each.id }, each.label));
    }
    return options;
  }

  private choose(id: string): void {
    this.add.value = '';
    const added = this.known.filter((each) => each.id === id || each.id.startsWith(`${id}:`));
    for (const each of added)
      if (!this.chosen.includes(each.id) && this.chosen.length < SERIES_MAX) this.chosen.push(each.id);
    this.showChips();
  }

  private showChips(): void {
    this.chips.replaceChildren(
      ...this.series.map((each) =>
        button(`${each.label} ×`, () => {
          this.chosen = this.chosen.filter((id) => id !== each.id);
          this.showChips();
        }, { class: 'chip', 'aria-label': `Remove ${each.label} from the plot` }),
      ),
    );
    this.changed();
  }

  private setHeld(at: number | null): void {
    this.heldAt = at;
    this.hold.setAttribute('aria-pressed', String(at !== null));
    setText(this.hold, at === null ? 'Pause' : 'Go on');
    if (at === null) this.scroll.value = '1';
    this.changed();
  }

  private scrollTo(share: number): void {
    const newest = this.history.newest ?? 0;
    const oldest = Math.max(this.history.oldest ?? 0, newest - WINDOW_S);
    if (share >= 1) return this.setHeld(null);
    const span = Number(this.span.value);
    this.setHeld(oldest + Math.min(span, newest - oldest) + share * Math.max(0, newest - oldest - span));
  }

  private listenToDrags(): void {
    let lastX: number | null = null;
    this.picture.addEventListener('pointerdown', (event) => {
      lastX = event.clientX;
      this.picture.setPointerCapture(event.pointerId);
    });
    this.picture.addEventListener('pointermove', (event) => {
      if (lastX === null) return;
      const perPixel = Number(this.span.value) / Math.max(1, this.picture.clientWidth);
      const at = (this.heldAt ?? this.history.newest ?? 0) - (event.clientX - lastX) * perPixel;
      lastX = event.clientX;
      const newest = this.history.newest ?? 0;
      this.setHeld(Math.min(newest, Math.max(newest - WINDOW_S, at)));
    });
    for (const name of ['pointerup', 'pointercancel'])
      this.picture.addEventListener(name, () => (lastX = null));
  }

  private request(): PlotRequest {
    const to = this.heldAt ?? this.history.newest ?? 0;
    return {
      series: this.series,
      robot: this.session.robot,
      from: to - Number(this.span.value),
      to,
      width: Math.max(280, this.picture.clientWidth),
      height: Math.max(120, this.picture.clientHeight),
      cursor: this.cursor,
      colours: {
        background: colourOf('panel'),
        text: colourOf('text'),
        muted: colourOf('muted'),
        line: colourOf('hair'),
        series: [1, 2, 3, 4, 5, 6].map((i) => colourOf(`series${i}`)),
      },
    };
  }

  private changed(): void {
    if (this.isDirty) return;
    this.isDirty = true;
    requestAnimationFrame(() => {
      this.isDirty = false;
      if (this.element.offsetParent === null) return;
      this.picture.replaceChildren(
        this.series.length === 0
          ? el('p', { class: 'empty' }, 'Choose joints or sensors with "Add series".')
          : (drawPlot(this.history, this.request()) as unknown as HTMLElement),
      );
    });
  }

  private saveSvg(): void {
    const text = new XMLSerializer().serializeToString(drawPlot(this.history, this.request()));
    saveFile('openr-plot.svg', 'image/svg+xml', `<?xml version="1.0" encoding="UTF-8"?>\n${text}\n`);
    this.session.good('openr-plot.svg saved');
  }

  private saveCsv(): void {
    const { from, to, robot } = this.request();
    saveFile('openr-plot.csv', 'text/csv', csvOf(this.history, this.series, robot, from, to));
    this.session.good('openr-plot.csv saved');
  }
}

export function makePlots(session: Session): HTMLElement {
  return new Plots(session).element;
}
