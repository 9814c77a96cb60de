// The graph of the objects and connections of a run, with the messages that pass through them.
import { button, el, setClass, setText, svg } from '../dom';
import { costText, rateText } from '../format';
import type { GraphConnection, GraphEvent, GraphObject } from '../protocol';
import type { Session } from '../session';
import { makeConnectionDetail } from './connection_detail';
import {
  curveThrough,
  layOut,
  LONE_HEIGHT,
  serviceName,
  shapeOf,
  type Placed,
  type Route,
} from './graph_layout';

// The most characters that fit into a line of a node.
const LINE_MAX = 28;

function clip(text: string, max = LINE_MAX): string {
  return text.length > max ? `${text.slice(0, max - 1)}…` : text;
}

class NodeView {
  readonly element = svg('g', { class: 'node' });
  private readonly name = svg('text', { class: 'name' });
  private readonly state = svg('text', { class: 'state' });
  private readonly load = svg('text', { class: 'load' });
  private readonly title = svg('title');
  private readonly isSmall: boolean;

  constructor(place: Placed) {
    this.isSmall = place.height <= LONE_HEIGHT;
    this.element.setAttribute('transform', `translate(${place.x},${place.y})`);
    this.element.append(
      this.title,
      svg('rect', { width: place.width, height: place.height, rx: 4 }),
    );
    const lines = this.isSmall ? [this.name, this.load] : [this.name, this.state, this.load];
    const top = place.height / 2 - (lines.length - 1) * 8.5 + 4;
    lines.forEach((line, i) => {
      line.setAttribute('x', '10');
      line.setAttribute('y', String(top + i * 17));
      this.element.append(line);
    });
  }

  show(object: GraphObject): void {
    const waits = object.waits_for ?? '';
    const queue = object.waiting > 0 ? ` · queue ${object.waiting}` : '';
    const found = object.findings > 0 ? ` ▲${object.findings}` : '';
    const load = `${rateText(object.per_s)} · ${costText(object.cost_us)}${queue}`;
    const waitText = `◔ waits for ${waits}`;
    const name = clip(`${object.name}${found}`, 25);
    setText(this.name, name);
    setClass(this.name, 'long', name.length > 18);
    setText(this.state, waits ? clip(waitText, 25) : clip(object.state || 'no state'));
    setText(this.load, clip(waits && this.isSmall ? waitText : load));
    setText(
      this.title,
      [
        object.name,
        `state: ${object.state || 'none'}`,
        waits ? `waits for ${waits}` : 'does not wait',
        `${object.messages} messages, ${rateText(object.per_s)}`,
        `longest handler ${costText(object.cost_us)}`,
        `queue ${object.waiting}, findings ${object.findings}`,
      ].join('\n'),
    );
    setClass(this.element as unknown as Element, 'waits', waits !== '');
    setClass(this.element as unknown as Element, 'found', object.findings > 0);
  }
}

class EdgeView {
  readonly element: SVGGElement;
  private readonly line: SVGPathElement;
  private readonly ready: SVGCircleElement;
  private readonly label = svg('text', { 'text-anchor': 'middle' });
  private readonly title = svg('title');

  constructor(connection: GraphConnection, route: Route, choose: () => void) {
    const path = curveThrough(route.points);
    this.line = svg('path', { d: path, class: 'line', 'marker-end': 'url(#arrow)' });
    const end = route.points[route.points.length - 1] ?? { x: 0, y: 0 };
    const before = route.points[route.points.length - 2] ?? end;
    const length = Math.hypot(end.x - before.x, end.y - before.y) || 1;
    this.ready = svg('circle', {
      cx: end.x - ((end.x - before.x) / length) * 14,
      cy: end.y - ((end.y - before.y) / length) * 14,
      r: 4,
    });
    this.label.setAttribute('x', String(route.label.x));
    this.label.setAttribute('y', String(route.label.y + 4));
    this.element = svg('g', {
      class: 'edge',
      role: 'button',
      tabindex: 0,
      'data-connection': connection.id,
      'aria-label': `Messages of ${connection.subject} to ${connection.observer}`,
    });
    this.element.append(this.title, svg('path', { d: path, class: 'hit' }), this.line, this.ready, this.label);
    this.element.addEventListener('click', choose);
    this.element.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      choose();
    });
  }

  show(connection: GraphConnection, isChosen: boolean): void {
    const queue = connection.waiting > 0 ? ` +${connection.waiting}` : '';
    setText(this.label, `${serviceName(connection.subject)} ${rateText(connection.per_s)}${queue}`);
    setText(this.title, edgeText(connection));
    const element = this.element as unknown as Element;
    setClass(element, 'ready', connection.ready === true);
    setClass(element, 'unknown', connection.ready === null || connection.ready === undefined);
    setClass(element, 'active', connection.per_s > 0);
    setClass(element, 'queued', connection.waiting > 0);
    setClass(element, 'chosen', isChosen);
  }
}

function readyText(connection: GraphConnection): string {
  if (connection.ready === true) return '● ready';
  return connection.ready === false ? '○ not ready' : '· unknown';
}

function edgeText(connection: GraphConnection): string {
  return [
    `${connection.subject} → ${connection.observer}`,
    readyText(connection),
    `${connection.sent} sent, ${rateText(connection.per_s)}`,
    `${connection.waiting} in the queue`,
  ].join('\n');
}

class GraphView {
  readonly element = el('div', { class: 'graph' });
  private readonly summary = el('p', { class: 'graph-summary' });
  private readonly picture = el('div', { class: 'graph-picture' });
  private readonly table = el('div', { class: 'graph-table', hidden: true });
  private readonly choices: HTMLButtonElement[];
  private readonly detail;
  private nodes = new Map<string, NodeView>();
  private edges = new Map<string, EdgeView>();
  private rows = new Map<string, HTMLElement>();
  private objectRows = new Map<string, HTMLElement>();
  private shape = '';
  private chosen = '';
  private isFormChosen = false; // a person has chosen between picture and list

  constructor(private readonly session: Session) {
    this.detail = makeConnectionDetail(session, () => this.choose(''));
    this.choices = [
      button('Picture', () => this.chooseForm('picture'), { 'aria-pressed': 'true' }),
      button('List', () => this.chooseForm('list'), { 'aria-pressed': 'false' }),
    ];
    this.element.append(
      el('div', { class: 'bar' }, this.summary, el('span', { class: 'segmented', role: 'group', 'aria-label': 'Graph as' }, ...this.choices)),
      el('div', { class: 'graph-body' }, this.picture, this.table, this.detail.element),
    );
    session.on('graph', (graph) => this.show(graph));
    session.on('robot', () => this.reshow());
    session.on('newRun', () => {
      this.shape = '';
      this.choose('');
    });
    window.addEventListener('panel-shown', () => this.reshow());
    window.addEventListener('resize', () => this.reshow());
  }

  private reshow(): void {
    if (this.session.graph !== null) this.show(this.session.graph);
  }

  private chooseForm(kind: 'picture' | 'list'): void {
    this.isFormChosen = true;
    this.showAs(kind);
    this.reshow();
  }

  private showAs(kind: 'picture' | 'list'): void {
    this.picture.hidden = kind !== 'picture';
    this.table.hidden = kind !== 'list';
    this.choices.forEach((each, i) =>
      each.setAttribute('aria-pressed', String((i === 0) === (kind === 'picture'))),
    );
  }

  private choose(id: string): void {
    this.chosen = id;
    this.element.classList.toggle('with-detail', id !== '');
    const connection = this.session.graph?.connections.find((each) => each.id === id);
    this.detail.show(connection ?? null);
    this.reshow();
  }

  private show(graph: GraphEvent): void {
    if (this.element.offsetParent === null) return;
    const objects = (graph.objects ?? []).filter((each) => each.robot === this.session.robot);
    const connections = (graph.connections ?? []).filter((each) => each.robot === this.session.robot);
    this.showSummary(objects, connections);
    const narrow = this.element.clientWidth < 560;
    // Shows a list in a narrow panel, because the picture would be too small to read.
    if (!this.isFormChosen) this.showAs(narrow ? 'list' : 'picture');
    const shape = `${narrow}${shapeOf(objects, connections)}`;
    if (shape !== this.shape) {
      this.shape = shape;
      this.build(objects, connections, narrow ? 'TB' : 'LR');
      this.buildTable(objects, connections);
    }
    for (const object of objects) {
      this.nodes.get(object.name)?.show(object);
      this.showObjectRow(object);
    }
    for (const each of connections) {
      this.edges.get(each.id)?.show(each, each.id === this.chosen);
      const row = this.rows.get(each.id);
      if (row === undefined) continue;
      const texts = [readyText(each), rateText(each.per_s), `${each.waiting} waiting`, `${each.sent} sent`];
      texts.forEach((text, i) => setText(row.children[i + 1] as Element, text));
      row.classList.toggle('chosen', each.id === this.chosen);
    }
  }

  private showSummary(objects: GraphObject[], connections: GraphConnection[]): void {
    const waits = objects.filter((each) => each.waits_for);
    setText(
      this.summary,
      waits.length > 0
        ? `◔ ${waits.map((each) => `${each.name} waits for ${each.waits_for}`).join('; ')}`
        : `${objects.length} objects, ${connections.length} connections; no object waits`,
    );
    this.summary.classList.toggle('warn', waits.length > 0);
  }

  private build(objects: GraphObject[], connections: GraphConnection[], direction: 'LR' | 'TB'): void {
    const layout = layOut(objects, connections, direction);
    const picture = svg('svg', {
      viewBox: `-6 -6 ${layout.width + 12} ${layout.height + 12}`,
      role: 'group',
      'aria-label': 'Objects and connections',
    });
    picture.style.setProperty('--width', `${layout.width}px`);
    picture.style.setProperty('--least', direction === 'LR' ? '0.72' : '0.8');
    const arrow = svg('marker', { id: 'arrow', viewBox: '0 0 8 8', refX: 7, refY: 4, markerWidth: 7, markerHeight: 7, orient: 'auto-start-reverse' });
    arrow.append(svg('path', { d: 'M0,0.5L8,4L0,7.5Z' }));
    picture.append(svg('defs', {}, arrow));
    this.nodes.clear();
    this.edges.clear();
    for (const each of connections) {
      const route = layout.routes.get(each.id);
      if (route === undefined) continue;
      const edge = new EdgeView(each, route, () => this.choose(each.id === this.chosen ? '' : each.id));
      this.edges.set(each.id, edge);
      picture.append(edge.element);
    }
    for (const [name, place] of layout.nodes) {
      const node = new NodeView(place);
      this.nodes.set(name, node);
      picture.append(node.element);
    }
    this.picture.replaceChildren(picture as unknown as HTMLElement);
  }

  private buildTable(objects: GraphObject[], connections: GraphConnection[]): void {
    this.rows.clear();
    this.objectRows.clear();
    const spans = () => Array.from({ length: 4 }, () => el('span'));
    for (const object of objects) {
      const name = el('span', { class: 'pair' }, object.name);
      this.objectRows.set(object.name, el('div', { class: 'graph-row object' }, name, ...spans()));
    }
    for (const each of connections) {
      const name = el('span', { class: 'pair' }, `${each.from} → ${each.to} `, el('small', {}, serviceName(each.subject)));
      const row = button('', () => this.choose(each.id === this.chosen ? '' : each.id), { class: 'graph-row' });
      row.append(name, ...spans());
      this.rows.set(each.id, row);
    }
    this.table.replaceChildren(
      el('h2', {}, 'Objects'),
      ...this.objectRows.values(),
      el('h2', {}, 'Connections'),
      ...this.rows.values(),
    );
  }

  private showObjectRow(object: GraphObject): void {
    const row = this.objectRows.get(object.name);
    if (row === undefined) return;
    const texts = [
      object.waits_for ? `◔ waits for ${object.waits_for}` : object.state || 'no state',
      rateText(object.per_s),
      costText(object.cost_us),
      `${object.waiting} waiting`,
    ];
    texts.forEach((text, i) => setText(row.children[i + 1] as Element, text));
    setClass(row, 'waits', Boolean(object.waits_for));
  }
}

export function makeGraph(session: Session): HTMLElement {
  return new GraphView(session).element;
}
