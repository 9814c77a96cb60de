import { describe, expect, it } from 'vitest';
import { forceOfDrag, intoBody, liftLine, liftOfDrag, pushLine } from '../../src/view/force';
import { PerspectiveCamera, Vector3 } from 'three';
import { metresPerPixel, Orbit, tiles } from '../../src/view/orbit';
import { csvOf, History, pathOf, rangeAround, seriesOf, ticks } from '../../src/panels/plot_data';
import { curveThrough, layOut, serviceName } from '../../src/panels/graph_layout';
import type { GraphConnection, GraphObject, Scene, ValuesEvent } from '../../src/protocol';

const scene: Scene = {
  time_s: 0,
  model: 'ERS-210',
  body: 'ode',
  grid_m: 0.1,
  world: { shapes: [] },
  robots: [
    {
      links: [],
      joints: [
        { name: 'neck_pan', title: 'Neck pan', locator: 'x', min_deg: -90, max_deg: 90, max_speed: 100, max_accel: 100 },
      ],
      leds: [],
      ears: [],
      sensors: [{ name: 'head_back', long_name: 'Head, "back"', locator: 'y', unit: 'force' }],
    },
  ],
};

function values(t: number, target: number | null, measured: number, force: number | null): ValuesEvent {
  return {
    event: 'values',
    time_s: t,
    robots: [{ state: '', joints: [[target, measured]], gains: [1], sensors: [force] }],
  };
}

describe('a drag on the dog', () => {
  it('pushes with a tenth of a newton for a pixel, and not too hard', () => {
    expect(forceOfDrag(50)).toBe(5);
    expect(forceOfDrag(5000)).toBe(40);
  });

  it('gives the force in the frame of the body', () => {
    const half = Math.SQRT1_2;
    // The dog has turned left by 90 degrees, so the x axis of the world is at its right.
    const force = intoBody([2, 0, 1], [half, 0, 0, half]);
    expect(force.map((each) => Number(each.toFixed(6)) + 0)).toEqual([0, -2, 1]);
  });

  it('becomes an input line', () => {
    expect(pushLine([1, -0.04, 2.26], 'LF_j2')).toBe('push 1.0 0.0 2.3 at LF_j2 for 100ms');
    expect(pushLine([1, 0, 0], 'a b; press chin')).toBe('push 1.0 0.0 0.0 for 100ms');
    expect(liftLine(liftOfDrag(100, 0.001))).toBe('lift 0.10');
    expect(liftOfDrag(-20, 0.001)).toBe(0);
  });
});

describe('Orbit', () => {
  it('never looks from below the floor or beyond the zenith', () => {
    const orbit = new Orbit();
    orbit.drag(0, 10000);
    expect(orbit.pitch).toBeLessThan(Math.PI / 2);
    orbit.drag(0, -20000);
    expect(orbit.pitch).toBeGreaterThan(-0.1);
  });

  it('looks at the face from the front, wherever the dog looks', () => {
    const orbit = new Orbit();
    orbit.look('front', Math.PI / 2);
    expect(orbit.eye().y).toBeGreaterThan(0.8);
    expect(Math.abs(orbit.eye().x)).toBeLessThan(1e-9);
  });

  it('divides the picture into a tile for each dog', () => {
    expect(tiles(1, 800, 400)).toEqual([{ x: 0, y: 0, width: 800, height: 400 }]);
    const two = tiles(2, 800, 400);
    expect(two.map((each) => each.x)).toEqual([0, 400]);
    expect(tiles(4, 800, 800).every((each) => each.width === 400 && each.height === 400)).toBe(true);
  });
});

describe('metresPerPixel', () => {
  it('is the width of a pixel, also in a narrow picture with a larger angle of view', () => {
    const rows = 600;
    for (const fov of [26, 52]) {
      const camera = new PerspectiveCamera(fov, 0.5, 0.02, 60);
      camera.updateMatrixWorld();
      const point = new Vector3(0.1, 0.2, -1.5);
      const above = point.clone().add(new Vector3(0, metresPerPixel(camera, point, rows), 0));
      const row = (at: Vector3) => (at.clone().project(camera).y * rows) / 2;
      expect(row(above) - row(point)).toBeCloseTo(1, 6);
    }
  });
});

describe('History', () => {
  const [joints, sensors] = seriesOf(scene, 0).map((each) => each.series);
  const measured = joints?.[1];
  const force = sensors?.[0];

  it('forgets what is older than a minute', () => {
    const history = new History();
    for (let t = 0; t <= 100; t += 1) history.add(values(t, 0, t, 0));
    expect(history.oldest).toBe(40);
    expect(history.newest).toBe(100);
  });

  it('takes samples away that are later than the time that came back', () => {
    const history = new History();
    for (const t of [1, 2, 3, 4]) history.add(values(t, 0, t, 0));
    history.add(values(2.5, 0, 9, 0));
    expect(history.times(0, 10)).toEqual([1, 2, 2.5]);
  });

  it('makes a table with empty fields for unknown values', () => {
    const history = new History();
    history.add(values(1, null, 2.5, 500000));
    history.add(values(2, 1, 3, null));
    const csv = csvOf(history, [...(joints ?? []), ...(sensors ?? [])], 0, 0, 10);
    expect(csv).toBe(
      'time_s,neck_pan commanded (°),neck_pan measured (°),head_back (N)\n' +
        '1.000000,,2.5,0.5\n2.000000,1,3,\n',
    );
  });

  it('draws a gap for unknown values', () => {
    const x = (t: number) => t;
    expect(pathOf([[0, 1], [1, null], [2, 3], [3, 4]], x, x)).toBe('M0.0,1.0M2.0,3.0L3.0,4.0');
  });

  it('reads SI units', () => {
    const history = new History();
    history.add(values(1, 0, 7, 250000));
    expect(history.points(force!, 0, 0, 2)).toEqual([[1, 0.25]]);
    expect(history.points(measured!, 0, 0, 2)).toEqual([[1, 7]]);
  });
});

describe('scales', () => {
  it('have round marks', () => {
    expect(ticks(0.3, 9.7, 5)).toEqual([2, 4, 6, 8]);
    expect(ticks(-0.1, 0.1, 4)).toEqual([-0.1, -0.05, 0, 0.05, 0.1]);
    expect(ticks(1, 1, 4)).toEqual([1]);
  });

  it('do not magnify noise', () => {
    const { min, max } = rangeAround([10, 10.01], '°');
    expect(max - min).toBeGreaterThan(2);
  });
});

describe('the object graph', () => {
  const object = (name: string): GraphObject => ({
    robot: 0, name, state: '', messages: 0, per_s: 0, waiting: 0, waits_for: '', cost_us: 0, findings: 0,
  });
  const link = (from: string, to: string, service: string): GraphConnection => ({
    id: `0:${from}.${service}>${to}.${service}`, robot: 0, from, to,
    subject: `${from}.${service}.Type.S`, observer: `${to}.${service}.Type.O`,
    ready: true, waiting: 0, sent: 0, per_s: 0,
  });
  const objects = ['A', 'B', 'Alone'].map(object);
  const links = [link('A', 'B', 'Go'), link('B', 'A', 'Back'), link('A', 'B', 'More')];

  it('places objects apart, and all lines and labels in the picture', () => {
    for (const direction of ['LR', 'TB'] as const) {
      const layout = layOut(objects, links, direction);
      const [a, b, alone] = ['A', 'B', 'Alone'].map((name) => layout.nodes.get(name)!);
      const apart = direction === 'LR' ? a!.x + a!.width <= b!.x : a!.y + a!.height <= b!.y;
      expect(apart).toBe(true);
      expect(alone!.y).toBeGreaterThan(Math.max(a!.y, b!.y));
      expect(layout.routes.size).toBe(3);
      for (const route of layout.routes.values()) {
        expect(route.label.x).toBeLessThanOrEqual(layout.width);
        expect(route.points.length).toBeGreaterThan(1);
      }
    }
  });

  it('keeps a connection of an object that has gone', () => {
    expect(layOut([], links, 'LR').nodes.has('B')).toBe(true);
  });

  it('lets lines of one side begin at different places', () => {
    const layout = layOut(objects, links, 'LR');
    const starts = links.map((each) => {
      const { points } = layout.routes.get(each.id)!;
      return each.from === 'A' ? points[0]!.y : points[points.length - 1]!.y;
    });
    expect(new Set(starts).size).toBe(3);
  });

  it('names services shortly', () => {
    expect(serviceName('RCServer.Mover.MoverCommand.S')).toBe('Mover');
    expect(curveThrough([{ x: 0, y: 0 }, { x: 1, y: 2 }])).toBe('M0.0,0.0L1.0,2.0');
  });
});
