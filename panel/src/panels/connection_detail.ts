// The last messages of one connection, decoded.
import { button, el, setText } from '../dom';
import { clockTime } from '../format';
import type { Answer, ConnectionMessage, GraphConnection } from '../protocol';
import type { Session } from '../session';

const PERIOD_MS = 700;

export interface ConnectionDetail {
  element: HTMLElement;
  show(connection: GraphConnection | null): void;
}

function messageElement(message: ConnectionMessage, isOpen: boolean): HTMLDetailsElement {
  const text = message.text ?? '';
  const [first = '', ...rest] = text.split('\n');
  const details = el(
    'details',
    { 'data-number': message.number, open: isOpen },
    el(
      'summary',
      {},
      el('time', {}, clockTime(message.time_s)),
      el('span', { class: 'number' }, `#${message.number}`),
      el('span', { class: 'first' }, first),
      el('span', { class: 'size' }, `${message.size} B`),
    ),
    el('pre', {}, rest.length > 0 ? text : first),
    message.hex ? el('pre', { class: 'hex' }, message.hex) : null,
  );
  return details;
}

export function makeConnectionDetail(session: Session, close: () => void): ConnectionDetail {
  const title = el('h2', {}, '');
  const list = el('div', { class: 'messages' });
  const hold = button('Hold', () => setHeld(!isHeld), { 'aria-pressed': 'false', title: 'Keeps the messages shown' });
  const element = el(
    'div',
    { class: 'detail', hidden: true },
    el('div', { class: 'bar' }, title, hold, button('×', close, { class: 'quiet', 'aria-label': 'Close the messages' })),
    list,
  );
  let id = '';
  let isHeld = false;
  let shown = '';

  function setHeld(is: boolean): void {
    isHeld = is;
    hold.setAttribute('aria-pressed', String(is));
  }

  async function refresh(): Promise<void> {
    const asked = id;
    if (asked === '' || isHeld || element.offsetParent === null || session.link !== 'open') return;
    try {
      const answer = await session.ask<{ messages: ConnectionMessage[] } & Answer>({ do: 'connection', connection: asked });
      if (asked === id && !isHeld) showMessages(answer.messages ?? []);
    } catch (error) {
      if (asked === id) list.replaceChildren(el('p', { class: 'hint' }, (error as Error).message));
    }
  }

  function showMessages(messages: ConnectionMessage[]): void {
    const key = messages.map((each) => each.number).join();
    if (key === shown) return;
    shown = key;
    // Leaves the list unchanged while a person has a message in it open, so that this message does
    // not disappear.
    if (list.querySelector('details[open]:not([data-first])') !== null) return;
    const top = messages[0];
    list.replaceChildren(...messages.slice(0, 20).map((each) => messageElement(each, each === top)));
    list.querySelector('details')?.setAttribute('data-first', '');
    if (messages.length === 0) list.append(el('p', { class: 'hint' }, 'No message yet.'));
  }

  window.setInterval(() => void refresh(), PERIOD_MS);
  return {
    element,
    show(connection) {
      const next = connection?.id ?? '';
      if (next === id) return;
      id = next;
      shown = '';
      setHeld(false);
      element.hidden = id === '';
      setText(title, connection === null ? '' : `${connection.from} → ${connection.to}`);
      title.title = connection === null ? '' : `${connection.subject} → ${connection.observer}`;
      list.replaceChildren(el('p', { class: 'hint' }, 'Asking for the last messages'));
      void refresh();
    },
  };
}
