"""A gait as numbers: key frames of a walk from harmonics of its joints, and how well it walks."""
import csv
import io
import math
import subprocess
import typing

import openr_host

FRAME_S = 0.016  # time between two key frames of a motion
HARMONICS = 2
LEGS = {"LF": ("LF", 0.0), "LH": ("LH", 0.0), "RF": ("LF", 0.5), "RH": ("LH", 0.5)}
TRACKS = ("LF_j1", "LF_j3", "LH_j1", "LH_j3")  # joints that swing; J2 keeps an angle
PER_TRACK = 1 + 2 * HARMONICS  # mean, then cosine and sine of each harmonic
SPREADS = ("LF_j2", "LH_j2")  # the last two numbers


class Walk(typing.NamedTuple):
    """How a robot has walked."""

    speed_mm_s: float
    drift: float     # way to the side, as a share of the way forward
    tilt_deg: float  # largest roll or pitch
    low_mm: float    # least height of the base
    errors: int      # error findings

    def is_good(self):
        """Returns whether the dog has walked upright and straight, without errors."""
        return self.tilt_deg < 30 and self.low_mm > 80 and self.drift < 0.1 and self.errors == 0


def dump(program, file):
    """Returns the key frames of a motion file: for each a dict of locators and degrees."""
    text = subprocess.run([program, "mtn", "dump", str(file)], check=True, stdout=subprocess.PIPE,
                          text=True).stdout
    return [{name: float(value) for name, value in row.items() if name.startswith("PRM:")}
            for row in csv.DictReader(io.StringIO(text))]


class Gait:
    """The numbers of a gait: harmonics of the joints of the left legs, and the number of key frames
    of a cycle.  The right legs do the same half a cycle later."""

    def __init__(self, numbers, frames):
        self.numbers, self.frames = list(numbers), frames

    @classmethod
    def of_cycle(cls, cycle, locators):
        """Returns the gait whose harmonics are those of the key frames `cycle`."""
        numbers, count = [], len(cycle) - 1  # the last key frame is the first one
        for track in TRACKS:
            values = [frame[locators[track]] for frame in cycle[:-1]]
            numbers.append(sum(values) / count)
            for k in range(1, HARMONICS + 1):
                for wave in (math.cos, math.sin):
                    numbers.append(2 / count * sum(
                        value * wave(2 * math.pi * k * i / count) for i, value in enumerate(values)))
        numbers += [cycle[0][locators[spread]] for spread in SPREADS]
        return cls(numbers, count)

    def angle(self, track, phase):
        if track in SPREADS:
            return self.numbers[len(TRACKS) * PER_TRACK + SPREADS.index(track)]
        at = TRACKS.index(track) * PER_TRACK
        mean, *waves = self.numbers[at:at + PER_TRACK]
        return mean + sum(
            waves[2 * k] * math.cos(2 * math.pi * (k + 1) * phase)
            + waves[2 * k + 1] * math.sin(2 * math.pi * (k + 1) * phase) for k in range(HARMONICS))

    def pose(self, phase, limits):
        """Returns the angles of the legs, within the limits of the joints."""
        pose = {}
        for leg, (source, shift) in LEGS.items():
            for number in (1, 2, 3):
                low, high, _ = limits[f"{leg}_j{number}"]
                angle = self.angle(f"{source}_j{number}", phase + shift)
                pose[f"{leg}_j{number}"] = min(high - 0.01, max(low + 0.01, angle))
        return pose

    def cycle(self, limits):
        """Returns the poses of a cycle, the last like the first.  A cycle that would ask more than
        the largest speed of a joint gets more key frames."""
        for frames in range(self.frames, 4 * self.frames):
            poses = [self.pose(i / frames, limits) for i in range(frames)]
            poses.append(poses[0])
            if is_within_speed(poses, limits):
                return poses
        return None


def is_within_speed(poses, limits):
    """Returns whether no joint is asked for more than its largest speed between two key frames."""
    return all(abs(now[name] - then[name]) <= limits[name][2] * FRAME_S
               for then, now in zip(poses, poses[1:]) for name in now)


def way(start, goal, limits):
    """Returns poses that lead from one pose to another, smoothly and within the joints' speeds."""
    for count in range(10, 200):
        shares = [i / count for i in range(count + 1)]
        poses = [{name: start[name] + (goal[name] - start[name]) * t * t * (3 - 2 * t) for name in goal}
                 for t in shares]
        if is_within_speed(poses, limits):
            return poses
    raise ValueError("the poses are too far apart")


def csv_of(poses, run, neck):
    """Returns key frames in the form of `openr mtn dump`; `neck` has the angles of the neck."""
    names = [*neck, *poses[0]]
    lines = [",".join(["key_frame", "time_ms", "roll_deg", "pitch_deg", "yaw_deg",
                       *(run.locators[name] for name in names)])]
    for i, pose in enumerate(poses):
        angles = {**neck, **pose}
        lines.append(",".join([str(i), str(16 * i), "0", "0", "0",
                               *(f"{angles[name]:.5f}" for name in names)]))
    return "\n".join(lines) + "\n"


def play_and_measure(run, start, cycle, seconds):
    """Uploads the motions `start` and `cycle` (bytes), plays them through RCServer, and returns how
    the robot has walked.  Returns None if it has fallen."""
    remote = openr_host.Remote(run)
    remote.upload("GOSTA.MTN", start)
    remote.upload("GO.MTN", cycle)
    remote.play("GOSTA.MTN")
    remote.wait()
    run.observe("x_m", "y_m", "yaw_deg", "roll_deg", "pitch_deg", "height_mm")
    x_m, y_m, yaw_deg, *_ = run.observation()
    remote.play("GO.MTN", 1000)  # far more than it will walk
    begin_s, tilt_deg, low_mm = run.time_s, 0.0, 1000.0
    while run.time_s - begin_s < seconds:
        at = run.act(frames=8)
        tilt_deg, low_mm = max(tilt_deg, abs(at[3]), abs(at[4])), min(low_mm, at[5])
        if tilt_deg > 60 or low_mm < 60:
            return None
    heading = math.radians(yaw_deg)
    dx_m, dy_m = at[0] - x_m, at[1] - y_m
    ahead_m = dx_m * math.cos(heading) + dy_m * math.sin(heading)
    aside_m = dy_m * math.cos(heading) - dx_m * math.sin(heading)
    errors = sum(finding.severity == "error" for finding in run.findings())
    return Walk(1000 * ahead_m / (run.time_s - begin_s), abs(aside_m) / max(abs(ahead_m), 1e-3),
                tilt_deg, low_mm, errors)
