// The log panel: the lines that objects have printed, with a filter, and the findings of the run.
import { button, el, setText } from '../dom';
import { clockTime } from '../format';
import { Ring } from '../ring';
import type { Finding, LogLine } from '../protocol';
import type { Session } from '../session';

const LINES_KEPT = 2000;
const LINES_SHOWN = 500;
const SAID_MAX = 120; // characters of a message that are shown with a finding

export function matches(text: string, filter: string): boolean {
  const words = filter.toLowerCase().split(/\s+/).filter(Boolean);
  const lower = text.toLowerCase();
  return words.every((word) => (word.startsWith('-') && word.length > 1 ? !lower.includes(word.slice(1)) : lower.includes(word)));
}

// Returns how many of the first lines of `sent` are also the last lines of `kept`.
function countKnown(kept: LogLine[], sent: LogLine[]): number {
  for (let count = Math.min(kept.length, sent.length); count > 0; --count) {
    const last = kept.slice(-count);
    if (last.every((line, i) => line.time_s === sent[i]?.time_s && line.text === sent[i]?.text)) return count;
  }
  return 0;
}

// Returns the lines that objects have printed. Calls `changed` when the lines have changed.
export function keepLines(session: Session, changed: () => void): Ring<LogLine> {
  const lines = new Ring<LogLine>(LINES_KEPT);
  let isFirst = true; // no lines have come through the present connection
  session.on('log', (event) => {
    const sent = event.lines ?? [];
    // Leaves out the lines that the page has, because the run sends its last lines again through
    // each new connection.
    const known = isFirst ? countKnown(lines.toArray(), sent) : 0;
    isFirst = false;
    for (const line of sent.slice(known)) lines.push(line);
    changed();
  });
  session.on('newRun', () => {
    lines.clear();
    changed();
  });
  session.on('link', ({ state }) => {
    if (state === 'open') isFirst = true;
  });
  return lines;
}

class LogView {
  readonly element: HTMLElement;
  private readonly lines: Ring<LogLine>;
  private readonly filter = el('input', {
    type: 'search',
    placeholder: 'Filter: words, -word leaves out',
    'aria-label': 'Filter of the log',
  });
  private readonly list = el('div', { class: 'log-lines', role: 'log', tabindex: 0, 'aria-label': 'Log', 'aria-live': 'off' });
  private readonly count = el('span', { class: 'caption' });
  private isDirty = false;

  constructor(session: Session) {
    this.filter.addEventListener('input', () => this.changed());
    this.element = el('div', { class: 'log' }, el('div', { class: 'bar' }, this.filter, this.count), this.list);
    this.lines = keepLines(session, () => this.changed());
    window.addEventListener('panel-shown', () => this.changed());
  }

  private changed(): void {
    if (this.isDirty) return;
    this.isDirty = true;
    window.setTimeout(() => this.draw(), 120);
  }

  private draw(): void {
    this.isDirty = false;
    if (this.element.offsetParent === null) return;
    const isAtEnd = this.list.scrollHeight - this.list.scrollTop - this.list.clientHeight < 30;
    const found = this.lines.toArray().filter((line) => matches(line.text ?? '', this.filter.value));
    const shown = found.slice(-LINES_SHOWN);
    this.list.replaceChildren(
      ...shown.map((line) =>
        el('div', {}, el('time', {}, clockTime(line.time_s)), el('span', {}, line.text ?? '')),
      ),
    );
    setText(this.count, `${found.length} of ${this.lines.length} lines`);
    if (isAtEnd) this.list.scrollTop = this.list.scrollHeight;
  }
}

const signs: Record<string, string> = { error: '✕', warning: '▲', note: '·', info: '·' };

// Returns the message that was handled when the finding was added, such as "message 12: boot"; '' if
// there was none.
export function handledText(finding: Finding): string {
  if (!finding.message) return '';
  const said = (finding.said ?? '').replaceAll('\n', '; ');
  if (said === '') return `message ${finding.message}`;
  return `message ${finding.message}: ${said.length > SAID_MAX ? said.slice(0, SAID_MAX - 3) + '...' : said}`;
}

// Makes a button that goes to the moment of a finding.
export function findingButton(session: Session, finding: Finding): HTMLElement {
  const severity = finding.severity ?? '';
  const target = button('', () => {
    if (!session.canRewind) {
      session.bad(`Cannot go to ${clockTime(finding.time_s)}: ${session.clock?.rewind?.why || 'this run keeps no past moments'}`);
      return;
    }
    void session.rewind({ to_s: finding.time_s });
  }, { class: 'finding', 'data-severity': severity, title: 'Goes to the moment of this finding' });
  target.append(
    el('span', { class: 'sign', 'aria-hidden': true }, signs[severity] ?? '·'),
    el('span', { class: 'severity' }, severity),
    el('time', {}, clockTime(finding.time_s)),
    el('span', { class: 'object' }, finding.object ?? ''),
    el('span', { class: 'text' }, finding.text ?? '', el('small', { class: 'handled' }, handledText(finding))),
    el('span', { class: 'count' }, (finding.count ?? 1) > 1 ? `${finding.count}×` : ''),
  );
  return target;
}

export function makeLog(session: Session): HTMLElement {
  const log = new LogView(session);
  const title = el('h2', {}, 'Findings');
  const list = el('div', { class: 'finding-list' }, el('p', { class: 'hint' }, 'None.'));
  const show = (findings: Finding[]) => {
    setText(title, findings.length === 0 ? 'Findings' : `Findings (${findings.length})`);
    list.replaceChildren(
      ...(findings.length === 0
        ? [el('p', { class: 'hint' }, 'None.')]
        : findings.slice(-200).map((each) => findingButton(session, each))),
    );
  };
  session.on('findings', (event) => show(event.findings ?? []));
  session.on('newRun', () => show([]));
  return el('div', { class: 'log-panel' }, el('div', { class: 'findings' }, title, list), log.element);
}
