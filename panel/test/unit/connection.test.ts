import { afterEach, describe, expect, it, vi } from 'vitest';
import { Connection, type LinkState } from '../../src/connection';

// A WebSocket that the test serves.
class FakeSocket {
  static readonly OPEN = 1;
  readonly readyState = FakeSocket.OPEN;
  onopen: () => void = () => undefined;
  onmessage: (message: { data: string }) => void = () => undefined;
  onclose: (event: { code: number; reason: string }) => void = () => undefined;

  constructor() {
    sockets.push(this);
  }
}

const sockets: FakeSocket[] = [];

function connect(): [LinkState, string][] {
  const states: [LinkState, string][] = [];
  vi.stubGlobal('WebSocket', FakeSocket);
  vi.stubGlobal('location', { href: 'http://127.0.0.1:8210/', protocol: 'http:' });
  vi.stubGlobal('window', { setTimeout: () => 0, clearTimeout: () => undefined });
  new Connection('', 'token', {
    onState: (state, why) => states.push([state, why]),
    onEvent: () => undefined,
  });
  return states;
}

function endWith(code: number, reason: string): void {
  const socket = sockets.pop();
  socket?.onopen();
  socket?.onmessage({ data: JSON.stringify({ event: 'ended', why: reason }) });
  socket?.onclose({ code, reason });
}

describe('the end of a connection', () => {
  afterEach(() => vi.unstubAllGlobals());

  it('is the end of the run if the server says so', () => {
    const states = connect();
    endWith(4001, 'the run has ended');
    expect(states.at(-1)).toEqual(['ended', 'the run has ended']);
  });

  it('is not the end of the run if the server has refused the page', () => {
    const states = connect();
    endWith(1013, '16 pages are open already; close one');
    expect(states.at(-1)).toEqual(['refused', '16 pages are open already; close one']);
  });
});
