// JointGoal: the value that the handle of a joint's slider shows. After a person has moved the
// handle, it stays there until the target in the run has reached this value, or until the robot
// does not go there.

const NEAR_DEG = 0.6;
const GIVE_UP_MS = 4000;

export class JointGoal {
  private goal: number | null = null;
  private setAt = 0;
  private nearest = Infinity;

  set(deg: number, nowMs: number): void {
    this.goal = deg;
    this.setAt = nowMs;
    this.nearest = Infinity;
  }

  clear(): void {
    this.goal = null;
  }

  // Returns the value for the handle. `target` is the joint's target in the run.
  show(target: number | null, nowMs: number): number | null {
    if (this.goal === null) return target;
    const distance = target === null ? Infinity : Math.abs(target - this.goal);
    if (distance < NEAR_DEG) {
      this.goal = null;
      return target;
    }
    // Keeps waiting while the target in the run comes nearer.
    if (distance < this.nearest - 0.01) {
      this.nearest = distance;
      this.setAt = nowMs;
    }
    if (nowMs - this.setAt > GIVE_UP_MS) {
      this.goal = null;
      return target;
    }
    return this.goal;
  }
}

// Returns the indices of joints sorted by error, the largest first. Joints without a target or an
// angle come last.
export function byError(joints: [number | null, number | null][]): number[] {
  const error = (i: number) => errorOf(joints[i]) ?? -1;
  return joints.map((_, i) => i).sort((a, b) => error(b) - error(a) || a - b);
}

export function errorOf(joint: [number | null, number | null] | undefined): number | null {
  const target = joint?.[0] ?? null;
  const measured = joint?.[1] ?? null;
  return target === null || measured === null ? null : Math.abs(target - measured);
}
