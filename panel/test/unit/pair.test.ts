import { describe, expect, it } from 'vitest';
import { Pair, targetsOf } from '../../src/pair';
import { largestDifference } from '../../src/panels/both';
import type { PairEvent } from '../../src/protocol';
import type { Session } from '../../src/session';

const ROBOT = '10.0.0.7:54000';

describe('targetsOf', () => {
  it('controls the simulation while no second robot is connected', () => {
    expect(targetsOf('move', '', true, 'none')).toEqual(['run']);
    expect(targetsOf('shutdown', '', true, 'none')).toEqual(['run']);
  });

  it('controls both dogs with the box, and only the robot without', () => {
    for (const call of ['move', 'speed', 'accel', 'led', 'ear', 'stop', 'motors']) {
      expect(targetsOf(call, ROBOT, true, 'none')).toEqual([ROBOT, 'run']);
      expect(targetsOf(call, ROBOT, false, 'none')).toEqual([ROBOT]);
    }
  });

  it('plays, uploads and shuts down at the robot only', () => {
    for (const call of ['play', 'motions', 'upload', 'delete', 'reboot', 'shutdown'])
      expect(targetsOf(call, ROBOT, true, 'none')).toEqual([ROBOT]);
  });

  it('moves the dog that leads, because the other one follows', () => {
    expect(targetsOf('move', ROBOT, true, 'simulation')).toEqual([ROBOT]);
    expect(targetsOf('move', ROBOT, true, 'robot')).toEqual(['run']);
    expect(targetsOf('move', ROBOT, false, 'robot')).toEqual(['run']);
    expect(targetsOf('led', ROBOT, true, 'robot')).toEqual([ROBOT, 'run']);
  });
});

describe('wish', () => {
  // A session whose server answers when the test says so.
  function connected() {
    const answers: ((answer: object | null) => void)[] = [];
    const session = {
      robot: 0,
      idOfNext: 1,
      emit: () => {},
      good: () => {},
      bad: () => {},
      ask: async () => ({ model: 'ERS-210' }),
      tell: () => new Promise((resolve) => answers.push(resolve)),
    };
    return { pair: new Pair(session as unknown as Session), answers };
  }
  const status = { pair: 1, state: 'connected' } as unknown as PairEvent;

  it('keeps what the user has chosen while a status comes before the answer', async () => {
    const { pair, answers } = connected();
    await pair.connect(ROBOT, 32);
    const first = pair.wish(false, 'none');
    answers[0]?.({});
    await first;
    const second = pair.wish(true, 'none');
    pair.take(status);
    expect(pair.wanted).toEqual({ simulation: true, follow: 'none' });
    expect(pair.simulation).toBe(false); // not accepted yet
    const third = pair.wish(pair.wanted.simulation, 'simulation');
    answers[1]?.({});
    answers[2]?.({});
    await Promise.all([second, third]);
    expect([pair.simulation, pair.follow]).toEqual([true, 'simulation']);
  });

  it('goes back to what the server has accepted when it refuses', async () => {
    const { pair, answers } = connected();
    await pair.connect(ROBOT, 32);
    const refused = pair.wish(true, 'robot');
    answers[0]?.(null);
    await refused;
    expect(pair.wanted).toEqual({ simulation: true, follow: 'none' });
  });
});

describe('largestDifference', () => {
  it('finds the joint that differs most', () => {
    expect(largestDifference([1, 20, -3], [1, 18, 4])).toEqual({ joint: 2, deg: 7 });
  });

  it('leaves out joints that one dog does not tell', () => {
    expect(largestDifference([null, 5, 50], [90, 4])).toEqual({ joint: 1, deg: 1 });
    expect(largestDifference([], [])).toEqual({ joint: -1, deg: 0 });
  });
});
