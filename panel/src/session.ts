// Session: the run that the page shows, its newest events, and the requests to it. Views subscribe
// to the topics that they draw.
import { Connection, type LinkState } from './connection';
import { Pair } from './pair';
import type {
  Answer,
  Clock,
  FindingsEvent,
  GraphEvent,
  LogEvent,
  PairEvent,
  PoseEvent,
  Request,
  Runs,
  Scene,
  UploadEvent,
  ValuesEvent,
} from './protocol';

export interface Topics {
  link: { state: LinkState; why: string };
  scene: Scene;
  pose: PoseEvent;
  values: ValuesEvent;
  graph: GraphEvent;
  findings: FindingsEvent;
  log: LogEvent;
  clock: Clock;
  upload: UploadEvent;
  runs: Runs;
  robot: number;
  newRun: string;
  rewind: Record<string, unknown>;
  branched: string;
  notice: { text: string; kind: 'good' | 'bad' };
  pair: Pair;
}

type Topic = keyof Topics;
type Listener<T extends Topic> = (value: Topics[T]) => void;

const EVENTS = ['pose', 'values', 'graph', 'log', 'findings', 'clock'] as const;
const RUNS_PERIOD_MS = 4000;

// Members that must be lists in an event. An event without these lists is ignored.
const LISTS: Record<string, string[]> = {
  pose: ['robots'],
  values: ['robots'],
  graph: ['objects', 'connections'],
  findings: ['findings'],
  log: ['lines'],
};

export class Session {
  scene: Scene | null = null;
  values: ValuesEvent | null = null;
  clock: Clock | null = null;
  graph: GraphEvent | null = null;
  runs: Runs | null = null;
  link: LinkState = 'connecting';
  run: string;
  robot = 0;
  readonly pair = new Pair(this);

  private connection: Connection | null = null;
  private readonly failed = new Set<Topic>(); // topics with an event that a view could not handle
  private readonly listeners = new Map<Topic, Listener<Topic>[]>();

  constructor(
    private readonly token: string,
    run: string,
  ) {
    this.run = run;
    window.setInterval(() => this.askRuns(), RUNS_PERIOD_MS);
  }

  on<T extends Topic>(topic: T, listener: Listener<T>): void {
    const all = this.listeners.get(topic) ?? [];
    all.push(listener as Listener<Topic>);
    this.listeners.set(topic, all);
  }

  emit<T extends Topic>(topic: T, value: Topics[T]): void {
    for (const listener of this.listeners.get(topic) ?? []) {
      try {
        listener(value);
      } catch (error) {
        // Prints the error and goes on, because an event that one view cannot handle must not stop
        // the other views.
        if (!this.failed.has(topic)) console.error(`panel: ${topic}:`, error);
        this.failed.add(topic);
      }
    }
  }

  // Shows the run `run`; "" means the run that has started the server.
  join(run: string): void {
    this.connection?.close();
    this.run = run;
    this.scene = null;
    this.values = null;
    this.clock = null;
    this.graph = null;
    this.robot = 0;
    this.pair.leave();
    this.emit('newRun', run);
    this.connection = new Connection(run, this.token, {
      onState: (state, why) => this.onState(state, why),
      onEvent: (name, event) => this.onEvent(name, event),
    });
  }

  chooseRobot(robot: number): void {
    this.robot = robot;
    this.emit('robot', robot);
  }

  ask<T = Answer>(request: Request): Promise<T> {
    if (this.connection === null) return Promise.reject(new Error('there is no run'));
    return this.connection.ask<T>(request);
  }

  get idOfNext(): number {
    return this.connection?.idOfNext ?? 0;
  }

  // Sends a request. If the answer is an error, shows the error and returns null.
  async tell<T = Answer>(request: Request, what: string): Promise<T | null> {
    try {
      return await this.ask<T>(request);
    } catch (error) {
      this.bad(`${what}: ${(error as Error).message}`);
      return null;
    }
  }

  input(line: string, robot = this.robot): Promise<Answer | null> {
    return this.tell({ do: 'input', robot, line }, line);
  }

  // Calls the remote control of the run, of the second robot, or of both at the same time. Returns
  // the first answer that is no error; null if there is none.
  async rc<T = Answer>(call: string, more: Record<string, unknown>, what: string): Promise<T | null> {
    const targets = this.pair.targets(call);
    const answers = targets.map((endpoint) => {
      const whose = targets.length === 1 ? '' : endpoint === 'run' ? ' (simulation)' : ' (robot)';
      return this.tell<T>({ do: 'rc', call, endpoint, robot: this.robot, ...more }, what + whose);
    });
    return (await Promise.all(answers)).find((answer) => answer !== null) ?? null;
  }

  async setClock(change: Record<string, unknown>): Promise<void> {
    const clock = await this.tell<Clock & Answer>({ do: 'clock', ...change }, 'Time');
    if (clock !== null) this.takeClock(clock);
  }

  async rewind(change: Record<string, unknown>): Promise<boolean> {
    this.emit('rewind', change);
    const clock = await this.tell<Clock & Answer>({ do: 'rewind', ...change }, 'Going back');
    if (clock !== null) this.takeClock(clock);
    return clock !== null;
  }

  // Returns whether the run is a recording or another known run, so that nobody can change it.
  get isRecording(): boolean {
    return this.clock?.length_s !== undefined;
  }

  get canRewind(): boolean {
    return this.link === 'open' && this.clock?.rewind?.possible === true;
  }

  good(text: string): void {
    this.emit('notice', { text, kind: 'good' });
  }

  bad(text: string): void {
    this.emit('notice', { text, kind: 'bad' });
  }

  private askRuns(): void {
    if (this.link !== 'open' || document.hidden) return;
    this.ask<Runs & Answer>({ do: 'runs' }).then(
      (runs) => {
        this.runs = runs;
        this.emit('runs', runs);
      },
      () => undefined,
    );
  }

  private onState(state: LinkState, why: string): void {
    this.link = state;
    if (state !== 'open') this.pair.leave();
    this.emit('link', { state, why });
    if (state === 'open') void this.begin();
  }

  private async begin(): Promise<void> {
    this.askRuns();
    const scene = await this.tell<Scene & Answer>({ do: 'scene' }, 'The scene of the run');
    if (scene !== null && Array.isArray(scene.robots)) {
      this.scene = scene;
      if (this.robot >= (scene.robots?.length ?? 1)) this.robot = 0;
      this.emit('scene', scene);
    }
    await this.tell({ do: 'watch', period_ms: 16, events: [...EVENTS] }, 'Watching the run');
  }

  private takeClock(clock: Clock): void {
    if (typeof clock.time_s !== 'number') return;
    this.clock = clock;
    this.emit('clock', clock);
  }

  private onEvent(name: string, event: Answer): void {
    const data = event as unknown;
    if ((LISTS[name] ?? []).some((member) => !Array.isArray(event[member]))) return;
    switch (name) {
      case 'pose':
        this.emit('pose', data as PoseEvent);
        break;
      case 'values':
        this.values = data as ValuesEvent;
        this.emit('values', this.values);
        break;
      case 'graph':
        this.graph = data as GraphEvent;
        this.emit('graph', this.graph);
        break;
      case 'findings':
        this.emit('findings', data as FindingsEvent);
        break;
      case 'log':
        this.emit('log', data as LogEvent);
        break;
      case 'clock':
        this.takeClock(data as Clock);
        break;
      case 'pair':
        this.pair.take(data as PairEvent);
        break;
      case 'upload':
        this.emit('upload', data as UploadEvent);
        break;
      case 'ended':
        this.onState('ended', typeof event['why'] === 'string' ? event['why'] : '');
        break;
      default:
        break; // a newer run may send events that this page does not know
    }
  }
}
