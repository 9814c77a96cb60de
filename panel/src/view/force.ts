// Converts a drag on the dog to a force in newtons, or to a height in metres.
import type { Vec3 } from '../protocol';

const NEWTON_PER_PIXEL = 0.1;
const NEWTON_MAX = 40;
const LIFT_MAX_M = 0.6;

// Returns the force of a drag over `length` pixels: small for a short drag, at most NEWTON_MAX for
// a long one.
export function forceOfDrag(length: number): number {
  return Math.min(NEWTON_MAX, length * NEWTON_PER_PIXEL);
}

// Converts a vector of the world to the frame of a body that has the orientation w, x, y, z (a
// quaternion).
export function intoBody(v: Vec3, [w, x, y, z]: [number, number, number, number]): Vec3 {
  // Uses the conjugate, which is the inverse of a unit quaternion: v' = q* v q.
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

// Returns the height of a lift by a drag of `pixels` upwards. One pixel is `metresPerPixel` wide.
export function liftOfDrag(pixels: number, metresPerPixel: number): number {
  return Math.min(LIFT_MAX_M, Math.max(0, pixels * metresPerPixel));
}

export function liftLine(metres: number): string {
  return `lift ${metres.toFixed(2)}`;
}
