// Hands: actions on the dog with the pointer in the picture, or with buttons.
import { button, el, setClass, svg } from '../dom';
import type { SensorData } from '../protocol';
import type { Session } from '../session';
import { forceOfDrag, intoBody, liftLine, liftOfDrag, pushLine } from './force';
import type { Stage, StageHit } from './stage';

type Tool = 'push' | 'lift';

const CLICK_PRESS_MS = 300;
const DRAG_MIN_PX = 6;

interface Drag {
  kind: 'orbit' | 'press' | 'push' | 'lift';
  robot: number;
  hit: StageHit | null;
  startX: number;
  startY: number;
  x: number;
  y: number;
}

// Makes `target` press a sensor while a pointer or a key holds the button down.
export function pressWhileHeld(
  target: HTMLButtonElement,
  press: () => void,
  release: () => void,
  pressShortly: () => void,
): void {
  let isHeld = false;
  const begin = () => {
    if (isHeld) return;
    isHeld = true;
    setClass(target, 'held', true);
    press();
  };
  const end = () => {
    if (!isHeld) return;
    isHeld = false;
    setClass(target, 'held', false);
    release();
  };
  target.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    target.setPointerCapture(event.pointerId);
    begin();
  });
  for (const name of ['pointerup', 'pointercancel', 'lostpointercapture', 'blur'])
    target.addEventListener(name, end);
  target.addEventListener('keydown', (event) => {
    if (event.key !== ' ' && event.key !== 'Enter') return;
    event.preventDefault();
    if (!event.repeat) begin();
  });
  target.addEventListener('keyup', end);
  target.addEventListener('click', (event) => {
    // Presses the sensor for a short time at a click without pointer or key: it comes from
    // assistive software, which cannot hold a button.
    if (event.detail === 0 && !isHeld) pressShortly();
  });
}

export class Hands {
  readonly toolBar = el('div', { class: 'hands', role: 'toolbar', 'aria-label': 'Hands' });
  readonly arrow = svg('svg', { class: 'force', 'aria-hidden': true });
  private readonly line = svg('line', {});
  private readonly tip = svg('path', {});
  private readonly label = svg('text', {});
  private readonly presses = el('span', { class: 'presses' });
  private tool: Tool = 'push';
  private drag: Drag | null = null;

  constructor(
    private readonly session: Session,
    private readonly stage: Stage,
  ) {
    this.arrow.append(this.line, this.tip, this.label);
    this.makeToolBar();
    this.listen();
    session.on('scene', () => this.showPresses());
    session.on('robot', () => this.showPresses());
  }

  private makeToolBar(): void {
    const tools = (['push', 'lift'] as const).map((tool) => {
      const choice = button(
        tool === 'push' ? 'Push' : 'Lift',
        () => {
          this.tool = tool;
          for (const each of tools)
            each.setAttribute('aria-pressed', each === choice ? 'true' : 'false');
        },
        {
          'aria-pressed': tool === this.tool ? 'true' : 'false',
          title: tool === 'push' ? 'Drag the dog to push it' : 'Drag the dog upwards to lift it',
        },
      );
      return choice;
    });
    this.toolBar.append(
      el('span', { class: 'group segmented', role: 'group', 'aria-label': 'A drag on the dog' }, ...tools),
      el(
        'span',
        { class: 'group' },
        button('Lift 10 cm', () => void this.session.input('lift 0.1')),
        button('Set down', () => void this.session.input('setdown')),
      ),
      el('span', { class: 'group press-group' }, el('span', { class: 'caption' }, 'Press'), this.presses),
    );
  }

  private showPresses(): void {
    const sensors = this.session.scene?.robots[this.session.robot]?.sensors ?? [];
    this.presses.replaceChildren(
      ...sensors.filter((each) => each.press && each.name).map((each) => this.pressButton(each)),
    );
  }

  private pressButton(sensor: SensorData): HTMLButtonElement {
    const target = button(sensor.name.replace(/_/g, ' '), () => undefined, {
      'aria-label': `Press ${sensor.name.replace(/_/g, ' ')}`,
      title: `${sensor.long_name}: pressed while you hold the button`,
    });
    pressWhileHeld(
      target,
      () => void this.session.input(`press ${sensor.name}`),
      () => void this.session.input(`release ${sensor.name}`),
      () => void this.session.input(`press ${sensor.name} for ${CLICK_PRESS_MS}ms`),
    );
    return target;
  }

  private listen(): void {
    const canvas = this.stage.canvas;
    canvas.addEventListener('pointerdown', (event) => this.begin(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', () => this.end(true));
    canvas.addEventListener('pointercancel', () => this.end(false));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        this.stage.orbit.zoom(Math.sign(event.deltaY));
        this.stage.touch();
      },
      { passive: false },
    );
    canvas.addEventListener('keydown', (event) => this.onKey(event));
  }

  private begin(event: PointerEvent): void {
    if (this.drag !== null) return;
    this.stage.canvas.setPointerCapture(event.pointerId);
    const { robot, hit } = this.stage.pick(event.clientX, event.clientY);
    if (this.stage.robotCount > 1 && robot !== this.session.robot) this.session.chooseRobot(robot);
    const kind =
      hit === null || event.button !== 0
        ? 'orbit'
        : this.tool === 'lift'
          ? 'lift'
          : hit.touch !== null
            ? 'press'
            : 'push';
    const [x, y] = [event.clientX, event.clientY];
    this.drag = { kind, robot, hit, startX: x, startY: y, x, y };
    if (kind === 'press') void this.session.input(`press ${hit?.touch}`, robot);
    this.stage.canvas.dataset['drag'] = kind;
  }

  private move(event: PointerEvent): void {
    const drag = this.drag;
    if (drag === null) {
      this.hover(event);
      return;
    }
    if (drag.kind === 'orbit') {
      this.stage.orbit.drag(event.clientX - drag.x, event.clientY - drag.y);
      this.stage.touch();
    }
    drag.x = event.clientX;
    drag.y = event.clientY;
    if (drag.kind === 'push' || drag.kind === 'lift') this.showArrow(drag);
  }

  private hover(event: PointerEvent): void {
    const { hit } = this.stage.pick(event.clientX, event.clientY);
    const canvas = this.stage.canvas;
    canvas.dataset['over'] = hit === null ? '' : hit.touch !== null && this.tool === 'push' ? 'touch' : 'body';
    canvas.title =
      hit === null
        ? ''
        : this.tool === 'lift'
          ? 'Drag upwards to lift'
          : hit.touch !== null
            ? `Press ${hit.touch.replace(/_/g, ' ')}`
            : `Drag to push (${hit.link.replace(/_/g, ' ')})`;
  }

  private end(isDone: boolean): void {
    const drag = this.drag;
    if (drag === null) return;
    this.drag = null;
    delete this.stage.canvas.dataset['drag'];
    this.arrow.classList.remove('shown');
    if (drag.kind === 'press') void this.session.input(`release ${drag.hit?.touch}`, drag.robot);
    const length = Math.hypot(drag.x - drag.startX, drag.y - drag.startY);
    if (!isDone || length < DRAG_MIN_PX) return;
    if (drag.kind === 'push') this.push(drag, length);
    if (drag.kind === 'lift') {
      const metres = this.liftOf(drag);
      if (metres > 0.005) void this.session.input(liftLine(metres), drag.robot);
    }
  }

  private push(drag: Drag, length: number): void {
    if (drag.hit === null) return;
    const { right, up } = this.stage.pixelAt(drag.hit);
    const force = right
      .multiplyScalar((drag.x - drag.startX) / length)
      .addScaledVector(up, (drag.startY - drag.y) / length)
      .multiplyScalar(forceOfDrag(length));
    const inBody = intoBody([force.x, force.y, force.z], this.stage.trunkOf(drag.robot));
    void this.session.input(pushLine(inBody, drag.hit.link), drag.robot);
  }

  private liftOf(drag: Drag): number {
    if (drag.hit === null) return 0;
    return liftOfDrag(drag.startY - drag.y, this.stage.pixelAt(drag.hit).metres);
  }

  private showArrow(drag: Drag): void {
    const box = this.stage.canvas.getBoundingClientRect();
    const [x1, y1] = [drag.startX - box.left, drag.startY - box.top];
    const isLift = drag.kind === 'lift';
    const [x2, y2] = [isLift ? x1 : drag.x - box.left, drag.y - box.top];
    const length = Math.hypot(x2 - x1, y2 - y1);
    this.arrow.classList.toggle('shown', length >= DRAG_MIN_PX);
    if (length < DRAG_MIN_PX) return;
    for (const [name, value] of Object.entries({ x1, y1, x2, y2 }))
      this.line.setAttribute(name, value.toFixed(1));
    const [ux, uy] = [(x2 - x1) / length, (y2 - y1) / length];
    this.tip.setAttribute(
      'd',
      `M${x2 + ux * 12},${y2 + uy * 12}L${x2 - uy * 6},${y2 + ux * 6}L${x2 + uy * 6},${y2 - ux * 6}Z`,
    );
    this.label.setAttribute('x', String(x2 + 14));
    this.label.setAttribute('y', String(y2 - 8));
    this.label.textContent = isLift
      ? `${(this.liftOf(drag) * 100).toFixed(0)} cm`
      : `${forceOfDrag(length).toFixed(1)} N`;
  }

  private onKey(event: KeyboardEvent): void {
    const orbit = this.stage.orbit;
    const turns: Record<string, () => void> = {
      ArrowLeft: () => orbit.drag(-12, 0),
      ArrowRight: () => orbit.drag(12, 0),
      ArrowUp: () => orbit.drag(0, 12),
      ArrowDown: () => orbit.drag(0, -12),
      '+': () => orbit.zoom(-1),
      '=': () => orbit.zoom(-1),
      '-': () => orbit.zoom(1),
      '0': () => this.stage.look('free', this.session.robot),
      '1': () => this.stage.look('front', this.session.robot),
      '2': () => this.stage.look('side', this.session.robot),
      '3': () => this.stage.look('top', this.session.robot),
    };
    const turn = turns[event.key];
    if (turn === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    turn();
    this.stage.touch();
  }
}
