// The data of the plots: the values of the last minute, with functions that make lines, scales and
// files of them.
import { quantityOf } from '../format';
import type { RobotValues, Scene, ValuesEvent } from '../protocol';

export const WINDOW_S = 60;
const SAMPLES_MAX = 1500;

export interface Series {
  id: string; // such as "joint:neck_pan:commanded" or "sensor:chin"
  label: string;
  unit: string;
  isDashed: boolean;
  read(robot: RobotValues): number | null;
}

interface Sample {
  t: number;
  robots: RobotValues[];
}

export class History {
  private samples: Sample[] = [];

  get length(): number {
    return this.samples.length;
  }

  get newest(): number | null {
    return this.samples[this.samples.length - 1]?.t ?? null;
  }

  get oldest(): number | null {
    return this.samples[0]?.t ?? null;
  }

  // Adds the values of an event. If its time is earlier than that of the newest sample, removes all
  // later samples.
  add(event: ValuesEvent): void {
    while (this.samples.length > 0 && (this.newest ?? 0) >= event.time_s) this.samples.pop();
    this.samples.push({ t: event.time_s, robots: event.robots });
    let drop = Math.max(0, this.samples.length - SAMPLES_MAX);
    while ((this.samples[drop]?.t ?? Infinity) < event.time_s - WINDOW_S) ++drop;
    if (drop > 0) this.samples.splice(0, drop);
  }

  clear(): void {
    this.samples = [];
  }

  // Returns the times and values of a series from `from` to `to`.
  points(series: Series, robot: number, from: number, to: number): [number, number | null][] {
    const points: [number, number | null][] = [];
    for (const sample of this.samples) {
      if (sample.t < from || sample.t > to) continue;
      const values = sample.robots[robot];
      points.push([sample.t, values === undefined ? null : series.read(values)]);
    }
    return points;
  }

  times(from: number, to: number): number[] {
    return this.samples.map((each) => each.t).filter((t) => t >= from && t <= to);
  }
}

// Returns all series of a scene by group, in the order of the scene.
export function seriesOf(scene: Scene, robot: number): { group: string; series: Series[] }[] {
  const data = scene.robots[robot];
  const joints = (data?.joints ?? []).map((joint, i) => {
    const make = (kind: 'commanded' | 'measured', at: 0 | 1): Series => ({
      id: `joint:${joint.name}:${kind}`,
      label: `${joint.name} ${kind}`,
      unit: '°',
      isDashed: kind === 'commanded',
      read: (values) => values.joints?.[i]?.[at] ?? null,
    });
    return [make('commanded', 0), make('measured', 1)];
  });
  const sensors = (data?.sensors ?? []).map((sensor, i): Series => {
    const quantity = quantityOf(sensor.unit);
    return {
      id: `sensor:${sensor.name || sensor.long_name}`,
      label: sensor.name || sensor.long_name,
      unit: sensor.unit === 'switch' ? '0/1' : quantity.symbol,
      isDashed: false,
      read: (values) => {
        const value = values.sensors?.[i];
        return value === null || value === undefined ? null : value * quantity.scale;
      },
    };
  });
  return [
    { group: 'Joints', series: joints.flat() },
    { group: 'Sensors', series: sensors },
  ];
}

// Returns about `count` round numbers from `min` to `max`.
export function ticks(min: number, max: number, count: number): number[] {
  const span = max - min;
  if (!(span > 0) || !Number.isFinite(span)) return [min];
  const raw = span / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = ([1, 2, 5, 10].find((each) => each * power >= raw) ?? 10) * power;
  const all: number[] = [];
  for (let i = Math.ceil(min / step - 1e-9); i * step <= max + step * 1e-9; ++i) all.push(Number((i * step).toPrecision(12)));
  return all;
}

// Returns a range that contains all `values`, with some space above and below them.
export function rangeAround(values: number[], unit: string): { min: number; max: number } {
  if (unit === '0/1') return { min: -0.15, max: 1.15 };
  if (values.length === 0) return { min: 0, max: 1 };
  let min = Math.min(...values);
  let max = Math.max(...values);
  const least = unit === '°' ? 2 : 0.02 * Math.max(1, Math.abs(max));
  if (max - min < least) {
    const middle = (min + max) / 2;
    min = middle - least / 2;
    max = middle + least / 2;
  }
  const room = (max - min) * 0.08;
  return { min: min - room, max: max + room };
}

function csvField(text: string): string {
  return /[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
}

// Returns a table as text: a column for the time, and one column for each series.
export function csvOf(history: History, series: Series[], robot: number, from: number, to: number): string {
  const head = ['time_s', ...series.map((each) => csvField(`${each.label} (${each.unit})`))];
  const columns = series.map((each) => history.points(each, robot, from, to));
  const rows = history.times(from, to).map((t, row) => [
    t.toFixed(6),
    ...columns.map((column) => {
      const value = column[row]?.[1];
      return value === null || value === undefined ? '' : String(Number(value.toPrecision(9)));
    }),
  ]);
  return [head, ...rows].map((row) => row.join(',')).join('\n') + '\n';
}

// Returns the line through `points` as an SVG path. Unknown values make a gap.
export function pathOf(
  points: [number, number | null][],
  x: (t: number) => number,
  y: (value: number) => number,
): string {
  let path = '';
  let isPen = false;
  for (const [t, value] of points) {
    if (value === null) {
      isPen = false;
      continue;
    }
    path += `${isPen ? 'L' : 'M'}${x(t).toFixed(1)},${y(value).toFixed(1)}`;
    isPen = true;
  }
  return path;
}
