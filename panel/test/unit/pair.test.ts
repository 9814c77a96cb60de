import { describe, expect, it } from 'vitest';
import { targetsOf } from '../../src/pair';
import { largestDifference } from '../../src/panels/both';

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

describe('largestDifference', () => {
  it('finds the joint that differs most', () => {
    expect(largestDifference([1, 20, -3], [1, 18, 4])).toEqual({ joint: 2, deg: 7 });
  });

  it('leaves out joints that one dog does not tell', () => {
    expect(largestDifference([null, 5, 50], [90, 4])).toEqual({ joint: 1, deg: 1 });
    expect(largestDifference([], [])).toEqual({ joint: -1, deg: 0 });
  });
});
