// LastValue: sends a value that changes quickly, such as that of a slider, at most once in a
// period. The last value is always sent.

export interface Timers {
  now(): number;
  after(ms: number, action: () => void): void;
}

const browserTimers: Timers = {
  now: () => performance.now(),
  after: (ms, action) => {
    setTimeout(action, ms);
  },
};

export class LastValue<T> {
  private pending: { value: T } | null = null;
  private isWaiting = false;
  private sentAt = -Infinity;

  // If `send` returns a promise, the next value waits until the promise is fulfilled.
  constructor(
    private readonly periodMs: number,
    private readonly send: (value: T) => Promise<unknown> | void,
    private readonly timers: Timers = browserTimers,
  ) {}

  set(value: T): void {
    this.pending = { value };
    this.pump();
  }

  // Drops the value that waits, if there is one.
  drop(): void {
    this.pending = null;
  }

  private pump(): void {
    if (this.isWaiting || this.pending === null) return;
    const wait = this.sentAt + this.periodMs - this.timers.now();
    this.isWaiting = true;
    if (wait > 0) {
      this.timers.after(wait, () => this.sendNow());
    } else {
      this.sendNow();
    }
  }

  private sendNow(): void {
    const pending = this.pending;
    this.pending = null;
    this.sentAt = this.timers.now();
    const goOn = () => {
      this.isWaiting = false;
      this.pump();
    };
    const sent = pending === null ? undefined : this.send(pending.value);
    if (sent === undefined) goOn();
    else sent.then(goOn, goOn);
  }
}
