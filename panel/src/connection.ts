// Connection: the WebSocket of the page to one run. It assigns answers to requests, and connects
// again after the connection was lost.
import type { Answer, Request } from './protocol';

export type LinkState = 'connecting' | 'open' | 'lost' | 'ended' | 'refused';

export interface ConnectionOwner {
  onState(state: LinkState, why: string): void;
  onEvent(name: string, event: Answer): void;
}

// Codes with which the server closes a connection that must not be opened again.
const CLOSE_RUN_ENDED = 4001;
const CLOSE_NO_RUN = 4002;
// Codes with which the server refuses a message of the page (1003, 1009) or the page (1013).
const REFUSALS = [1003, 1009, 1013];

// Returns the wait before attempt number `attempt` to connect again: 0.5 s, then twice as long each
// time, at most 8 s.
export function waitBeforeAttemptMs(attempt: number): number {
  return Math.min(8000, 500 * 2 ** Math.min(attempt, 10));
}

interface Waiting {
  resolve(answer: Answer): void;
  reject(error: Error): void;
}

export class Connection {
  private socket: WebSocket | null = null;
  private readonly waiting = new Map<unknown, Waiting>();
  private nextId = 1;
  private attempt = 0;
  private timer = 0;
  private isClosed = false;
  private hasEnded = false;

  constructor(
    private readonly run: string,
    private readonly token: string,
    private readonly owner: ConnectionOwner,
  ) {
    this.open();
  }

  // Sends a request and returns the promise of its answer. If the run answers with an error, the
  // promise is rejected with the text of this error.
  ask<T = Answer>(request: Request): Promise<T> {
    const socket = this.socket;
    if (socket === null || socket.readyState !== WebSocket.OPEN)
      return Promise.reject(new Error('there is no connection to the run'));
    const id = this.nextId++;
    return new Promise<T>((resolve, reject) => {
      this.waiting.set(id, { resolve: (answer) => resolve(answer as T), reject });
      socket.send(JSON.stringify({ ...request, id }));
    });
  }

  // Returns the number that the next request will get.
  get idOfNext(): number {
    return this.nextId;
  }

  close(): void {
    this.isClosed = true;
    window.clearTimeout(this.timer);
    this.socket?.close();
    this.rejectAll('the page has left this run');
  }

  private open(): void {
    this.owner.onState('connecting', '');
    const address = new URL('ws', location.href);
    address.protocol = location.protocol === 'https:' ? 'wss:' : 'ws:';
    address.search = this.run === '' ? '' : `?run=${encodeURIComponent(this.run)}`;
    address.hash = '';
    const socket = new WebSocket(address, `openr.${this.token}`);
    this.socket = socket;
    let wasOpen = false;
    socket.onopen = () => {
      wasOpen = true;
      this.attempt = 0;
      this.owner.onState('open', '');
    };
    socket.onmessage = (message) => this.take(message.data);
    socket.onclose = (event) => this.onClose(event, wasOpen);
  }

  private onClose(event: CloseEvent, wasOpen: boolean): void {
    this.rejectAll('the connection to the run was lost');
    if (this.isClosed) return;
    if (this.hasEnded && REFUSALS.includes(event.code)) {
      this.owner.onState('refused', event.reason);
      return;
    }
    if (this.hasEnded || event.code === CLOSE_RUN_ENDED || event.code === CLOSE_NO_RUN) {
      this.owner.onState('ended', event.reason || 'the run has ended');
      return;
    }
    this.owner.onState(
      !wasOpen && this.attempt >= 2 ? 'refused' : 'lost',
      !wasOpen && this.attempt >= 2
        ? 'The server does not answer, or does not know this page. Open the address that openr run printed.'
        : event.reason,
    );
    this.timer = window.setTimeout(() => this.open(), waitBeforeAttemptMs(this.attempt++));
  }

  private take(data: unknown): void {
    if (typeof data !== 'string') return;
    let message: unknown;
    try {
      message = JSON.parse(data);
    } catch {
      return;
    }
    if (typeof message !== 'object' || message === null) return;
    const answer = message as Answer;
    if (typeof answer['event'] === 'string') {
      if (answer['event'] === 'ended') this.hasEnded = true;
      this.owner.onEvent(answer['event'], answer);
      return;
    }
    const id = answer['id'];
    const waiting = this.waiting.get(id);
    if (waiting === undefined) return;
    this.waiting.delete(id);
    if (typeof answer['error'] === 'string') waiting.reject(new Error(answer['error']));
    else waiting.resolve(answer);
  }

  private rejectAll(why: string): void {
    const all = [...this.waiting.values()];
    this.waiting.clear();
    for (const each of all) each.reject(new Error(why));
  }
}
