import { describe, expect, it } from 'vitest';
import { clockTime, costText, degrees, fixed, rateText, sensorText } from '../../src/format';
import { LastValue } from '../../src/last_value';
import { Ring } from '../../src/ring';
import { byError, errorOf, JointGoal } from '../../src/panels/joint_goal';
import { handledText, keepLines, matches } from '../../src/panels/log';
import { Touch } from '../../src/panels/touch';
import { waitBeforeAttemptMs } from '../../src/connection';
import type { Session } from '../../src/session';

describe('numbers', () => {
  it('are unknown where the run sends none', () => {
    expect(degrees(null)).toBe('unknown');
    expect(fixed(Number.NaN, 1)).toBe('unknown');
    expect(sensorText(null, 'force')).toBe('unknown');
  });

  it('have a minus sign, but not for a zero', () => {
    expect(fixed(-1.25, 1)).toBe('\u22121.3');
    expect(fixed(-0.01, 1)).toBe('0.0');
  });

  it('are shown in SI units', () => {
    expect(sensorText(490332, 'force')).toBe('0.490 N');
    expect(sensorText(-9806650, 'acceleration')).toBe('\u22129.81 m/s²');
    expect(sensorText(30000000, 'temperature')).toBe('30.0 °C');
    expect(sensorText(1, 'switch')).toBe('pressed');
    expect(sensorText(512, 'counts')).toBe('512 counts');
  });

  it('show virtual time to a millisecond', () => {
    expect(clockTime(75.25)).toBe('1:15.250');
    expect(clockTime(59.9999)).toBe('1:00.000');
  });

  it('show rates and costs', () => {
    expect(rateText(0)).toBe('0/s');
    expect(rateText(2.66)).toBe('2.7/s');
    expect(costText(1500)).toBe('1.5 ms');
    expect(costText(250)).toBe('250 µs');
  });
});

describe('Ring', () => {
  it('keeps the last items in order', () => {
    const ring = new Ring<number>(3);
    for (const i of [1, 2, 3, 4, 5]) ring.push(i);
    expect(ring.toArray()).toEqual([3, 4, 5]);
    expect(ring.at(0)).toBe(3);
    expect(ring.last()).toBe(5);
  });
});

describe('LastValue', () => {
  const setUp = () => {
    const sent: number[] = [];
    const later: { at: number; action: () => void }[] = [];
    const clock = { now: 0 };
    const value = new LastValue<number>(50, (v) => void sent.push(v), {
      now: () => clock.now,
      after: (ms, action) => later.push({ at: clock.now + ms, action }),
    });
    const goTo = (now: number) => {
      clock.now = now;
      for (const each of later.splice(0)) each.action();
    };
    return { value, sent, goTo };
  };

  it('sends the first value at once and then only the last one', () => {
    const { value, sent, goTo } = setUp();
    for (const i of [1, 2, 3, 4]) value.set(i);
    expect(sent).toEqual([1]);
    goTo(50);
    expect(sent).toEqual([1, 4]);
  });

  it('does not send a value that was dropped', () => {
    const { value, sent, goTo } = setUp();
    for (const i of [1, 2]) value.set(i);
    value.drop();
    goTo(50);
    expect(sent).toEqual([1]);
    value.set(3);
    goTo(100);
    expect(sent).toEqual([1, 3]);
  });

  it('waits for the answer to a value before it sends the next one', async () => {
    let answer: () => void = () => undefined;
    const sent: number[] = [];
    const value = new LastValue<number>(
      0,
      (v) => {
        sent.push(v);
        return new Promise<void>((resolve) => (answer = resolve));
      },
      { now: () => 0, after: (_, action) => action() },
    );
    value.set(1);
    value.set(2);
    value.set(3);
    expect(sent).toEqual([1]);
    answer();
    await Promise.resolve();
    await Promise.resolve();
    expect(sent).toEqual([1, 3]);
  });
});

describe('JointGoal', () => {
  it('keeps what the person chose until the target has come there', () => {
    const goal = new JointGoal();
    goal.set(30, 0);
    expect(goal.show(0, 10)).toBe(30);
    expect(goal.show(20, 3000)).toBe(30);
    expect(goal.show(29.8, 4000)).toBe(29.8);
    expect(goal.show(10, 4100)).toBe(10);
  });

  it('gives up when the target does not come nearer', () => {
    const goal = new JointGoal();
    goal.set(30, 0);
    expect(goal.show(5, 100)).toBe(30);
    expect(goal.show(5, 4200)).toBe(5);
  });
});

describe('errors of joints', () => {
  it('are unknown without a target', () => {
    expect(errorOf([null, 4])).toBeNull();
    expect(errorOf(undefined)).toBeNull();
  });

  it('put the largest one first and unknown ones last', () => {
    expect(byError([[0, 1], [null, 50], [3, -3], [0, 0]])).toEqual([2, 0, 3, 1]);
  });
});

describe('the filter of the log', () => {
  it('wants every word, and none that begins with a minus', () => {
    expect(matches('state: standing', 'STAND state')).toBe(true);
    expect(matches('state: standing', 'stand -state')).toBe(false);
    expect(matches('anything', '')).toBe(true);
    expect(matches('a - b', '-')).toBe(true);
  });
});

describe('the lines of the log', () => {
  it('come once, also if the run sends them again after the connection was lost', () => {
    const listeners = new Map<string, (value: unknown) => void>();
    const session = { on: (topic: string, listener: (value: unknown) => void) => listeners.set(topic, listener) };
    const lines = keepLines(session as unknown as Session, () => undefined);
    const line = { time_s: 1, text: 'state: running' };
    for (let connection = 0; connection < 2; ++connection) {
      listeners.get('link')?.({ state: 'open', why: '' });
      listeners.get('log')?.({ event: 'log', lines: [line] });
      listeners.get('link')?.({ state: 'lost', why: '' });
    }
    expect(lines.toArray()).toEqual([line]);
    const next = { time_s: 2, text: 'state: waiting' };
    const last = { time_s: 3, text: 'state: running' };
    listeners.get('log')?.({ event: 'log', lines: [next] });
    // The run sends its newest lines again, which are fewer than the page has.
    listeners.get('link')?.({ state: 'open', why: '' });
    listeners.get('log')?.({ event: 'log', lines: [next, last] });
    expect(lines.toArray()).toEqual([line, next, last]);
  });
});

describe('a finding', () => {
  const finding = { severity: 'warning', robot: 0, object: 'A', time_s: 1, text: 'is slow' };

  it('names the message that was handled, and what it says on one line', () => {
    expect(handledText({ ...finding, message: 12, said: 'a\nb' })).toBe('message 12: a; b');
    expect(handledText({ ...finding, message: 12, said: '' })).toBe('message 12');
    expect(handledText({ ...finding, message: 12, said: 'x'.repeat(200) })).toBe(`message 12: ${'x'.repeat(117)}...`);
  });

  it('has no message if none was handled, or in a run of an older program', () => {
    expect(handledText({ ...finding, message: 0, said: '' })).toBe('');
    expect(handledText(finding)).toBe('');
  });
});

describe('connecting again', () => {
  it('waits longer each time, up to eight seconds', () => {
    expect([0, 1, 2, 3, 4, 5, 50].map(waitBeforeAttemptMs)).toEqual([500, 1000, 2000, 4000, 8000, 8000, 8000]);
  });
});

describe('a touched control', () => {
  it('shows the value of the run again when the last change is answered', () => {
    const touch = new Touch();
    expect(touch.isOver()).toBe(true);
    touch.begin();
    const first = touch.change();
    touch.begin();
    expect(touch.isOver()).toBe(false);
    const second = touch.change();
    first();
    expect(touch.isOver()).toBe(false);
    second();
    expect(touch.isOver()).toBe(true);
  });

  it('is still touched if the person goes on before the answer', () => {
    const touch = new Touch();
    touch.begin();
    const answer = touch.change();
    touch.begin();
    answer();
    expect(touch.isOver()).toBe(false);
  });
});
