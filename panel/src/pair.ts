// Pair: the second robot that is controlled together with the dog of the run, and the choice of the
// robots to which commands go (Hohl 2004, section 3.3.1).
import type { Answer, PairAnswer, PairEvent } from './protocol';
import type { Session } from './session';

export type PairPhase = 'none' | 'connecting' | 'connected' | 'closing';
export type Follow = 'none' | 'simulation' | 'robot';

// Calls that go to one robot only: calls about files, and those that end the robot's run.
const ONE_ROBOT = ['motions', 'upload', 'download', 'delete', 'play', 'reboot', 'shutdown', 'connect'];

// Returns the endpoints (addresses of remote controls) to which a call goes.
export function targetsOf(call: string, endpoint: string, simulation: boolean, follow: Follow): string[] {
  if (endpoint === '') return ['run'];
  if (ONE_ROBOT.includes(call)) return [endpoint];
  // Sends a position only to the dog that leads, because the other dog gets its positions from it.
  if (call === 'move' && follow === 'simulation') return [endpoint];
  if (call === 'move' && follow === 'robot') return ['run'];
  return simulation ? [endpoint, 'run'] : [endpoint];
}

export class Pair {
  phase: PairPhase = 'none';
  endpoint = '';
  // Whether the box "simulation" is checked. It always is while no second robot is connected.
  simulation = true;
  follow: Follow = 'none';
  // The values that the user has chosen last.  They are those above once the server has accepted them.
  // The controls show these values, so that a second change does not undo the first one.
  wanted: { simulation: boolean; follow: Follow } = { simulation: true, follow: 'none' };
  answer: PairAnswer | null = null;
  status: PairEvent | null = null;
  why = ''; // the reason why the last connection was lost

  private id: unknown = null; // id of the request that has connected the second robot
  private robot = 0;
  private wishes = 0; // number of calls of wish()

  constructor(private readonly session: Session) {}

  get isConnected(): boolean {
    return this.phase === 'connected';
  }

  // Returns the motion that the second robot plays; "" means none.
  get motion(): string {
    return this.isConnected ? (this.status?.motion ?? '') : '';
  }

  targets(call: string): string[] {
    const endpoint = this.isConnected && this.session.robot === this.robot ? this.endpoint : '';
    return targetsOf(call, endpoint, this.simulation, this.follow);
  }

  async connect(endpoint: string, periodMs: number): Promise<void> {
    if (this.phase !== 'none') return;
    this.set({ phase: 'connecting', endpoint, why: '' });
    this.robot = this.session.robot;
    this.id = this.session.idOfNext;
    try {
      this.answer = await this.session.ask<PairAnswer & Answer>({
        do: 'pair', call: 'connect', robot: this.robot, endpoint, period_ms: periodMs,
      });
      this.set({ phase: 'connected' });
      const first = this.answer.first_time ? '; lights and ears are reset' : '';
      this.session.good(`Connected to ${endpoint}, ${this.answer.model}${first}`);
    } catch (error) {
      this.reset((error as Error).message);
      this.session.bad(`Not connected to ${endpoint}: ${(error as Error).message}`);
    }
  }

  async disconnect(): Promise<void> {
    if (!this.isConnected) return;
    this.set({ phase: 'closing' });
    await this.session.tell({ do: 'pair', call: 'disconnect', robot: this.robot }, 'Disconnect');
  }

  // Asks the server to change the box "simulation" or the robot that follows.  If the server refuses
  // the last wish, the values that it has accepted are wanted again.
  async wish(simulation: boolean, follow: Follow): Promise<void> {
    if (!this.isConnected) return;
    const wanted = simulation || follow !== 'simulation' ? follow : 'none';
    this.wishes += 1;
    const number = this.wishes;
    this.wanted = { simulation, follow: wanted };
    this.set({});
    const answer = await this.session.tell(
      { do: 'pair', call: 'set', robot: this.robot, simulation, follow: wanted },
      'Both dogs',
    );
    if (answer === null && number === this.wishes)
      this.wanted = { simulation: this.simulation, follow: this.follow };
    this.set(answer === null ? {} : { simulation, follow: wanted });
  }

  // Forgets the second robot, because the page has lost the connection to its server.
  leave(): void {
    if (this.phase !== 'none') this.reset('');
  }

  take(event: PairEvent): void {
    if (event.pair !== this.id) return; // the event belongs to an earlier connection
    if (event.state === 'connected') {
      this.status = event;
      this.set({});
    } else if (this.phase === 'connected' && event.state === 'lost') {
      const why = (event.why ?? '').replace(`${event.endpoint}: `, '');
      this.reset(`the connection to ${event.endpoint} was lost (${why})`);
      this.session.bad(`The connection to ${event.endpoint} was lost: ${why}`);
    } else if (this.phase !== 'connecting') {
      this.reset('');
    }
  }

  private reset(why: string): void {
    this.id = null;
    this.answer = null;
    this.status = null;
    this.wanted = { simulation: true, follow: 'none' };
    this.set({ phase: 'none', simulation: true, follow: 'none', why });
  }

  private set(change: Partial<Pick<Pair, 'phase' | 'endpoint' | 'simulation' | 'follow' | 'why'>>): void {
    Object.assign(this, change);
    this.session.emit('pair', this);
  }
}
