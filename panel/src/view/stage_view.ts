// The picture of the dogs with the controls above it: views, the moment that is shown, hands.
import { button, el, setText } from '../dom';
import { clockTime } from '../format';
import type { Session } from '../session';
import { Hands } from './hands';
import { Stage } from './stage';

function makeBadge(session: Session): HTMLElement {
  const badge = el('div', { class: 'moment', hidden: true });
  session.on('clock', (clock) => {
    const shows = clock.rewind?.shows_s;
    const isPast = shows !== null && shows !== undefined;
    badge.hidden = !isPast && !clock.paused;
    badge.dataset['kind'] = isPast ? 'past' : 'paused';
    setText(
      badge,
      isPast ? `◀ Past: ${clockTime(shows)}` : `❚❚ Paused at ${clockTime(clock.time_s)}`,
    );
  });
  return badge;
}

function makeTileNames(session: Session): HTMLElement {
  const names = el('div', { class: 'tile-names', 'aria-hidden': true });
  const show = () => {
    const count = session.scene?.robots.length ?? 0;
    names.replaceChildren();
    if (count < 2) return;
    for (let i = 0; i < count; ++i)
      names.append(el('span', { class: i === session.robot ? 'chosen' : '' }, `Robot ${i + 1}`));
  };
  session.on('scene', show);
  session.on('robot', show);
  return names;
}

export function makeStageView(session: Session): HTMLElement {
  const stage = new Stage();
  const hands = new Hands(session, stage);
  session.on('scene', (scene) => stage.setScene(scene));
  session.on('pose', (pose) => stage.setPose(pose));
  session.on('clock', () => {
    hands.toolBar.inert = session.isRecording;
  });
  const views = el(
    'div',
    { class: 'views', role: 'group', 'aria-label': 'View' },
    ...(['front', 'side', 'top', 'free'] as const).map((view) =>
      button(
        view === 'free' ? 'Reset' : view[0]?.toUpperCase() + view.slice(1),
        () => stage.look(view, session.robot),
        { class: 'quiet', title: view === 'free' ? 'Key 0' : `Look from the ${view}` },
      ),
    ),
  );
  return el(
    'section',
    { class: 'stage', 'aria-label': 'Dog' },
    el(
      'div',
      { class: 'picture' },
      stage.canvas,
      hands.arrow as unknown as HTMLElement,
      stage.works
        ? null
        : el('p', { class: 'no-webgl' }, 'This browser has no WebGL, so the dog cannot be drawn. All else works.'),
      makeTileNames(session),
      makeBadge(session),
      views,
    ),
    hands.toolBar,
  );
}
