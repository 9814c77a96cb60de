// What a drag on the dog means: a force in newtons, or a height in metres.
import type { Vec3 } from '../protocol';

const NEWTON_PER_PIXEL = 0.1;
const NEWTON_MAX = 40;
const LIFT_MAX_M = 0.6;

// Force of a drag over `length` pixels. Short drags push gently, long ones at most with NEWTON_MAX.
export function forceOfDrag(length: number): number {
  return Math.min(NEWTON_MAX, length * NEWTON_PER_PIXEL);
}

// Turns a vector of the world into the frame of a body with the quaternion w, x, y, z.
export function intoBody(v: Vec3, [w, x, y, z]: [number, number, number, number]): Vec3 {
  // The inverse of a unit quaternion is its conjugate: v' = q* v q.
  const [a, b, c] = [-x, -y, -z];
  const tx = 2 * (b * v[2] - c * v[1]);
  const ty = 2 * (c * v[0] - a * v[2]);
  const tz = 2 * (a * v[1] - b * v[0]);
  return [
    v[0] + w * tx + (b * tz - c * ty),
    v[1] + w * ty + (c * tx - a * tz),
    v[2] + w * tz + (a * ty - b * tx),
  ];
}

function number(value: number): string {
  const text = value.toFixed(1);
  return text === '-0.0' ? '0.0' : text;
}

export function pushLine(force: Vec3, part: string): string {
  const at = /^[A-Za-z0-9_]+$/.test(part) ? ` at ${part}` : '';
  return `push ${force.map(number).join(' ')}${at} for 100ms`;
}

// Height of a lift by a drag of `pixels` upwards, when a pixel is `metresPerPixel` wide.
export function liftOfDrag(pixels: number, metresPerPixel: number): number {
  return Math.min(LIFT_MAX_M, Math.max(0, pixels * metresPerPixel));
}

export function liftLine(metres: number): string {
  return `lift ${metres.toFixed(2)}`;
}
