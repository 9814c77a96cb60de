// Orbit: the place of the camera around a point that follows the dog. Angles are in radians, z is
// up.
import type { PerspectiveCamera, Vector3 } from 'three';

export interface Point {
  x: number;
  y: number;
  z: number;
}

export type ViewName = 'front' | 'side' | 'top' | 'free';

const FREE = { yaw: -0.66, pitch: 0.36, distance: 0.98 };
const PITCH_MIN = -0.05;
const PITCH_MAX = Math.PI / 2 - 0.001;
const DISTANCE_MIN = 0.25;
const DISTANCE_MAX = 6;

export class Orbit {
  yaw = FREE.yaw; // direction of the camera, seen from the target; 0 is along x
  pitch = FREE.pitch; // angle of the camera above the floor
  distance = FREE.distance;
  readonly target: Point = { x: 0, y: 0, z: 0.12 };
  private isPlaced = false;

  // Turns the camera by a drag over `dx`, `dy` pixels.
  drag(dx: number, dy: number): void {
    this.yaw -= dx * 0.008;
    this.pitch = Math.min(PITCH_MAX, Math.max(PITCH_MIN, this.pitch + dy * 0.006));
  }

  zoom(steps: number): void {
    this.distance = Math.min(DISTANCE_MAX, Math.max(DISTANCE_MIN, this.distance * 1.1 ** steps));
  }

  // Turns the camera to a view. `heading` is the direction in which the dog looks.
  look(view: ViewName, heading: number): void {
    this.distance = FREE.distance;
    this.pitch = view === 'top' ? PITCH_MAX : view === 'free' ? FREE.pitch : 0.1;
    this.yaw =
      heading +
      (view === 'front' ? 0 : view === 'side' ? -Math.PI / 2 : view === 'top' ? Math.PI : FREE.yaw);
  }

  // Moves the target towards the trunk, which is at `at`. Returns whether the camera has moved
  // visibly.
  follow(at: Point, share: number): boolean {
    const z = Math.max(0.1, at.z - 0.02);
    const k = this.isPlaced ? share : 1;
    this.isPlaced = true;
    const dx = (at.x - this.target.x) * k;
    const dy = (at.y - this.target.y) * k;
    const dz = (z - this.target.z) * k;
    this.target.x += dx;
    this.target.y += dy;
    this.target.z += dz;
    return Math.abs(dx) + Math.abs(dy) + Math.abs(dz) > 1e-5;
  }

  // Returns the place of the camera.
  eye(): Point {
    const flat = Math.cos(this.pitch) * this.distance;
    return {
      x: this.target.x + Math.cos(this.yaw) * flat,
      y: this.target.y + Math.sin(this.yaw) * flat,
      z: this.target.z + Math.sin(this.pitch) * this.distance,
    };
  }
}

// Returns the rectangles of `count` tiles in a picture of `width` x `height`, beginning at the
// upper left.
export function tiles(
  count: number,
  width: number,
  height: number,
): { x: number; y: number; width: number; height: number }[] {
  const columns = Math.max(1, Math.ceil(Math.sqrt((count * width) / Math.max(1, height) / 1.2)));
  const used = Math.min(columns, count);
  const rows = Math.ceil(count / Math.max(1, used));
  return Array.from({ length: count }, (_, i) => ({
    x: ((i % used) * width) / used,
    y: (Math.floor(i / used) * height) / rows,
    width: width / used,
    height: height / rows,
  }));
}

// Returns the width in metres of a pixel at `point`, in a picture of `camera` that has `rows` rows of
// pixels.
export function metresPerPixel(camera: PerspectiveCamera, point: Vector3, rows: number): number {
  const depth = -point.clone().applyMatrix4(camera.matrixWorldInverse).z;
  return (2 * depth * Math.tan((camera.fov * Math.PI) / 360)) / rows;
}
