// Layout: decides which panels are in which region of the page, depending on the width of the page.
// A region with more than one panel has tabs.
import { button, el } from './dom';

export interface PanelDef {
  id: string;
  title: string;
  element: HTMLElement;
}

type Regions = Record<string, string[]>;

// Layouts from the widest to the narrowest; the first layout that fits is used.
const layouts: { name: string; minWidth: number; regions: Regions }[] = [
  {
    name: 'ultra',
    minWidth: 1900,
    regions: {
      lower: ['graph', 'log'],
      lower2: ['plots'],
      side: ['joints'],
      side2: ['motions'],
      side3: ['sensors'],
      side4: ['robot', 'both'],
    },
  },
  {
    name: 'wide',
    minWidth: 1180,
    regions: { lower: ['graph', 'plots', 'log'], side: ['joints', 'sensors', 'robot', 'both'], side2: ['motions'] },
  },
  {
    name: 'medium',
    minWidth: 720,
    regions: { lower: ['graph', 'plots', 'log'], side: ['joints', 'motions', 'sensors', 'robot', 'both'] },
  },
  {
    name: 'narrow',
    minWidth: 0,
    regions: { lower: ['joints', 'motions', 'sensors', 'graph', 'plots', 'log', 'robot', 'both'] },
  },
];

class Region {
  readonly element = el('section', { class: 'region' });
  private readonly tabs = el('div', { class: 'tabs', role: 'tablist' });
  private readonly body = el('div', { class: 'region-body' });
  private panels: PanelDef[] = [];
  shown = '';

  constructor(readonly name: string) {
    this.element.dataset['region'] = name;
    this.element.append(this.tabs, this.body);
    this.tabs.addEventListener('keydown', (event) => this.onKey(event));
  }

  fill(panels: PanelDef[]): void {
    this.panels = panels;
    this.body.replaceChildren(...panels.map((each) => each.element));
    this.element.hidden = panels.length === 0;
    const first = panels[0];
    if (first === undefined) return;
    const isKept = panels.some((each) => each.id === this.shown);
    this.show(isKept ? this.shown : first.id);
  }

  has(id: string): boolean {
    return this.panels.some((each) => each.id === id);
  }

  show(id: string): void {
    this.shown = id;
    this.tabs.replaceChildren(
      ...this.panels.map((each) => {
        const isShown = each.id === id;
        each.element.hidden = !isShown;
        return button(each.title, () => this.show(each.id), {
          role: 'tab',
          id: `tab-${each.id}`,
          'aria-selected': isShown ? 'true' : 'false',
          'aria-controls': `panel-${each.id}`,
          tabindex: isShown ? 0 : -1,
        });
      }),
    );
    window.dispatchEvent(new CustomEvent('panel-shown', { detail: id }));
  }

  private onKey(event: KeyboardEvent): void {
    const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (step === 0) return;
    const at = this.panels.findIndex((each) => each.id === this.shown);
    const next = this.panels[(at + step + this.panels.length) % this.panels.length];
    if (next === undefined) return;
    event.preventDefault();
    this.show(next.id);
    this.tabs.querySelector<HTMLElement>('[aria-selected="true"]')?.focus();
  }
}

export class Layout {
  readonly element = el('main', {});
  private readonly regions = ['lower', 'lower2', 'side', 'side2', 'side3', 'side4'].map(
    (name) => new Region(name),
  );
  private name = '';

  constructor(
    private readonly panels: PanelDef[],
    stage: HTMLElement,
    time: HTMLElement,
  ) {
    for (const panel of panels) {
      panel.element.id = `panel-${panel.id}`;
      panel.element.classList.add('panel');
      panel.element.setAttribute('role', 'tabpanel');
      panel.element.setAttribute('aria-label', panel.title);
    }
    this.element.append(stage, time, ...this.regions.map((each) => each.element));
    window.addEventListener('resize', () => this.arrange());
    this.arrange();
  }

  // Shows the panel `id` in front of the other panels of its region.
  show(id: string): void {
    this.regions.find((each) => each.has(id))?.show(id);
  }

  private arrange(): void {
    const layout = layouts.find((each) => window.innerWidth >= each.minWidth);
    if (layout === undefined || layout.name === this.name) return;
    this.name = layout.name;
    this.element.dataset['layout'] = layout.name;
    document.body.dataset['layout'] = layout.name;
    for (const region of this.regions) {
      const ids = layout.regions[region.name] ?? [];
      region.fill(
        ids.flatMap((id) => this.panels.filter((each) => each.id === id)),
      );
    }
  }
}
