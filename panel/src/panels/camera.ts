// The picture of the robot's camera and its colour layer. The page requests them only while they
// are visible.
import { button, el, setText } from '../dom';
import { clockTime } from '../format';
import type { Session } from '../session';

const PERIOD_MS = 200;
const PERIOD_AFTER_ERROR_MS = 2000;

export function makeCamera(session: Session): HTMLElement {
  let layer: 'picture' | 'colour' = 'picture';
  let isInView = false;
  let isAsking = false;
  let nextAt = 0;
  const image = el('img', { alt: 'Picture of the camera in the head', hidden: true, width: 176, height: 144 });
  const text = el('p', { class: 'camera-text' }, 'No picture yet');
  const choices = (['picture', 'colour'] as const).map((each) =>
    button(
      each === 'picture' ? 'Picture' : 'Colour layer',
      () => {
        layer = each;
        nextAt = 0;
        choices.forEach((choice, i) =>
          choice.setAttribute('aria-pressed', String((i === 0) === (layer === 'picture'))),
        );
      },
      { 'aria-pressed': String(each === layer) },
    ),
  );
  const element = el(
    'div',
    { class: 'camera' },
    el('div', { class: 'bar' }, el('h2', {}, 'Camera'), el('span', { class: 'segmented', role: 'group' }, ...choices)),
    el('div', { class: 'camera-picture' }, image),
    text,
  );
  new IntersectionObserver((entries) => {
    isInView = entries[entries.length - 1]?.isIntersecting === true;
  }).observe(element);

  async function ask(): Promise<void> {
    isAsking = true;
    const asked = layer;
    try {
      const answer = await session.ask<{ png?: unknown; time_s?: number }>({
        do: 'camera',
        robot: session.robot,
        layer: asked,
      });
      if (typeof answer.png === 'string' && /^[A-Za-z0-9+/=]+$/.test(answer.png) && asked === layer) {
        image.src = `data:image/png;base64,${answer.png}`;
        image.hidden = false;
        setText(text, `${asked === 'picture' ? 'Picture' : 'Colour layer'} at ${clockTime(answer.time_s ?? 0)}`);
      }
      nextAt = performance.now() + PERIOD_MS;
    } catch (error) {
      image.hidden = true;
      setText(text, `No picture: ${(error as Error).message}`);
      nextAt = performance.now() + PERIOD_AFTER_ERROR_MS;
    } finally {
      isAsking = false;
    }
  }

  window.setInterval(() => {
    const canAsk = isInView && !document.hidden && session.link === 'open' && !isAsking;
    if (canAsk && performance.now() >= nextAt) void ask();
  }, PERIOD_MS / 2);
  return element;
}
