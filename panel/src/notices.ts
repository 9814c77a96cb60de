// Notices: short texts at the lower edge of the page about actions that were done or refused.
import { button, el } from './dom';
import type { Session } from './session';

const SHOWN_MAX = 3;
const GOOD_MS = 4000;
const BAD_MS = 12_000;

export function makeNotices(session: Session): HTMLElement {
  const list = el('div', { class: 'notices', role: 'status', 'aria-live': 'polite' });
  session.on('notice', ({ text, kind }) => {
    const shown = [...list.children].find((each) => each.getAttribute('data-text') === text);
    shown?.remove();
    while (list.children.length >= SHOWN_MAX) list.firstElementChild?.remove();
    const note = el(
      'div',
      { class: `notice ${kind}`, 'data-text': text },
      el('span', { class: 'sign', 'aria-hidden': true }, kind === 'good' ? '✓' : '!'),
      el('span', { class: 'text' }, text),
      button('×', () => note.remove(), { class: 'close', 'aria-label': 'Close this message' }),
    );
    list.append(note);
    window.setTimeout(() => note.remove(), kind === 'good' ? GOOD_MS : BAD_MS);
  });
  return list;
}
