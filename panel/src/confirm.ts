// ConfirmButton: a button that asks for confirmation in its own place before it acts.
import { button, el } from './dom';

const BACK_AFTER_MS = 8000;

export interface ConfirmTexts {
  label: string; // text on the button
  question: string; // question before the action: "Delete WALK.MTN?"
  yes: string; // text of the button that confirms: "Delete"
  aria?: string; // label for screen readers, needed if `label` is only a symbol
  className?: string;
}

export function confirmButton(texts: ConfirmTexts, act: () => void): HTMLElement {
  const place = el('span', { class: 'confirm' });
  let timer = 0;
  const first = button(texts.label, ask, {
    class: texts.className ?? '',
    'aria-label': texts.aria,
  });
  place.append(first);

  function back(): void {
    window.clearTimeout(timer);
    const hadFocus = place.contains(document.activeElement);
    place.classList.remove('asking');
    place.removeAttribute('role');
    place.removeAttribute('aria-label');
    place.replaceChildren(first);
    if (hadFocus) first.focus();
  }

  function ask(): void {
    const yes = button(
      texts.yes,
      () => {
        back();
        act();
      },
      { class: 'danger' },
    );
    const no = button('No', back);
    place.classList.add('asking');
    place.setAttribute('role', 'group');
    place.setAttribute('aria-label', texts.question);
    place.replaceChildren(el('span', { class: 'question' }, texts.question), yes, no);
    yes.focus();
    timer = window.setTimeout(back, BACK_AFTER_MS);
  }

  place.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && place.classList.contains('asking')) {
      event.stopPropagation();
      back();
    }
  });
  return place;
}
