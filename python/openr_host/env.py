"""AiboEnv: a dog that learns to walk, with the functions reset and step of learning libraries.

If the library Gymnasium is installed, AiboEnv is a gymnasium.Env with spaces of that library, and
passes its checker.  Without Gymnasium (Debian has no package) the interface is the same:
`reset(seed=, options=)` returns observation and info; `step(action)` returns observation, reward,
terminated, truncated and info.
"""
from __future__ import annotations

import importlib
import math
import random
from typing import Any, Optional, Sequence

from .errors import RunEnded
from .run import Run

numpy: Any = None  # NumPy is missing, so observations are lists
gymnasium: Any = None
try:
    # Imported by name, because type checkers report an import statement of a module that is missing.
    numpy = importlib.import_module("numpy")
    gymnasium = importlib.import_module("gymnasium")
except ImportError:
    pass
_Base: Any = object if gymnasium is None else gymnasium.Env


class Box:
    """A space of numbers between limits, in place of gymnasium.spaces.Box if Gymnasium is missing."""

    def __init__(self, low: Sequence[float], high: Sequence[float]) -> None:
        self.low, self.high = list(low), list(high)
        self.shape = (len(self.low),)
        self._random = random.Random()

    def seed(self, seed: Optional[int] = None) -> None:
        self._random.seed(seed)

    def sample(self) -> list[float]:
        return [self._random.uniform(low, high) for low, high in zip(self.low, self.high)]

    def contains(self, values: Sequence[float]) -> bool:
        return len(values) == len(self.low) and all(
            low <= value <= high for low, value, high in zip(self.low, values, self.high))


def _box(low: Sequence[float], high: Sequence[float]) -> Any:
    if gymnasium is None or numpy is None:
        return Box(low, high)
    return gymnasium.spaces.Box(numpy.array(low, numpy.float32), numpy.array(high, numpy.float32))


LEGS = ("LF", "LH", "RF", "RH")
LEG_JOINTS = tuple(f"{leg}_j{number}" for leg in LEGS for number in (1, 2, 3))


def _shares(action: Sequence[float]) -> list[float]:
    """Returns the numbers of `action`, limited to -1 to 1.  Raises ValueError if they are not 12 finite
    numbers."""
    shares = [float(share) for share in action]
    if len(shares) != len(LEG_JOINTS):
        raise ValueError(f"an action has {len(LEG_JOINTS)} numbers, one for each leg joint; this one has {len(shares)}")
    for name, share in zip(LEG_JOINTS, shares):
        if not math.isfinite(share):
            raise ValueError(f"the action for {name} is {share}; it must be a finite number, from -1 to 1")
    return [min(1.0, max(-1.0, share)) for share in shares]


class AiboEnv(_Base):  # type: ignore[misc]
    """A dog that stands at the beginning.  An action moves the set points of its 12 leg joints for
    `frames` frames of 8 ms; the reward is the way forward in m, less `effort` times the mean square of
    the action.

    action       12 numbers from -1 to 1: set points, `reach_deg` about those of standing, inside
                 the limits of the joints, and no faster than their motors plan (`keep_speed`)
    observation  12 angles and 12 speeds of the leg joints (as shares of 90 degrees and of 360
                 degrees/s), roll and pitch (of 90 degrees), 3 velocities of the base (m/s, in the
                 world), 3 angular velocities (of 360 degrees/s), 4 paws that touch (0 or 1)
    terminated   the dog has fallen: roll or pitch of more than 45 degrees, or the base below 60 mm;
                 or the run is over
    truncated    `episode_s` are over
    info         x_m, y_m, time_s; ended_by if the run is over
    """

    metadata: dict[str, Any] = {"render_modes": []}
    render_mode = None

    def __init__(self, frames: int = 4, episode_s: float = 10.0, reach_deg: float = 30.0,
                 effort: float = 0.0, disturb_deg: float = 2.0, keep_speed: bool = True,
                 **run: Any) -> None:
        """Makes the run and lets the dog stand up.  At a reset, each leg joint is moved at random by
        at most `disturb_deg`.  Further parameters are those of Run: body, world, seed, program."""
        self._frames, self._episode_s, self._effort = frames, episode_s, effort
        self._disturb_deg = disturb_deg
        self._random = random.Random(0)
        run = {"writable": False, "battery": "100%", **run}
        self._run = Run(**run)
        self._run.until_standing()
        self._run.run(0.5)
        stance = self._run.targets()
        self._stance = [stance[name] for name in LEG_JOINTS]
        limits = [self._run.limits[name] for name in LEG_JOINTS]
        self._low = [max(low, mid - reach_deg) for (low, _, _), mid in zip(limits, self._stance)]
        self._high = [min(high, mid + reach_deg) for (_, high, _), mid in zip(limits, self._stance)]
        self._reach = reach_deg
        step_s = frames * 0.008
        self._step_deg = [speed * step_s if keep_speed else math.inf for _, _, speed in limits]
        self._run.actuate(*LEG_JOINTS)
        self._run.observe(
            *(f"joint.{name}" for name in LEG_JOINTS), *(f"speed.{name}" for name in LEG_JOINTS),
            "roll_deg", "pitch_deg", "vx_m_s", "vy_m_s", "vz_m_s", "wx_deg_s", "wy_deg_s", "wz_deg_s",
            "paws", "x_m", "y_m", "height_mm")
        self._start = self._run.save()
        self.action_space = _box([-1.0] * 12, [1.0] * 12)
        self.observation_space = _box([-math.inf] * 36, [math.inf] * 36)
        self._targets = list(self._stance)
        self._begin_s = self._run.time_s
        self._x_m = 0.0
        self._last: Sequence[float] = ()

    @property
    def run(self) -> Run:
        """The run of the present episode."""
        return self._run

    def reset(self, *, seed: Optional[int] = None,
              options: Optional[dict[str, Any]] = None) -> tuple[Any, dict[str, Any]]:
        """Goes back to the state in which the dog stood.  `seed` decides all that is random from now on."""
        if gymnasium is not None:
            super().reset(seed=seed)
        if seed is not None:
            self._random.seed(seed)
        self._run.go_back(self._start)
        self._targets = [mid + self._random.uniform(-self._disturb_deg, self._disturb_deg)
                         for mid in self._stance]
        self._run.act(self._targets, frames=25)
        values = self._run.act(None, frames=25)
        self._begin_s, self._x_m = self._run.time_s, values[36]
        return self._observe(values)

    def step(self, action: Sequence[float]) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Moves the set points and runs `frames` frames.

        Numbers below -1 count as -1, numbers above 1 as 1.  Raises ValueError, and changes nothing, if
        the action does not have 12 numbers or if one of them is not finite.
        """
        shares = _shares(action)
        for i, share in enumerate(shares):
            wanted = self._stance[i] + self._reach * share
            wanted = min(self._high[i], max(self._low[i], wanted))
            way = wanted - self._targets[i]
            self._targets[i] += min(self._step_deg[i], max(-self._step_deg[i], way))
        ended: dict[str, Any] = {}
        try:
            values: Sequence[float] = self._run.act(self._targets, frames=self._frames)
        except RunEnded as end:
            ended, values = {"ended_by": end.by}, self._last
        observation, info = self._observe(values)
        info.update(ended)
        way_m, self._x_m = values[36] - self._x_m, values[36]
        effort = sum(share ** 2 for share in shares) / 12
        has_fallen = max(abs(values[24]), abs(values[25])) > 45 or values[38] < 60
        is_over = self._run.time_s - self._begin_s >= self._episode_s - 1e-6
        return (observation, way_m - self._effort * effort, has_fallen or bool(ended), is_over, info)

    def _observe(self, values: Sequence[float]) -> tuple[Any, dict[str, Any]]:
        self._last = values
        shares = [each / 90 for each in values[:12]] + [each / 360 for each in values[12:24]]
        shares += [values[24] / 90, values[25] / 90, *values[26:29]]
        shares += [each / 360 for each in values[29:32]] + list(values[32:36])
        info = {"x_m": values[36], "y_m": values[37], "time_s": self._run.time_s}
        return (shares if numpy is None else numpy.array(shares, numpy.float32)), info

    def render(self) -> None:
        """Does nothing, because `run.picture(FILE)` writes pictures."""

    def close(self) -> None:
        self._run.close()
        self._start.drop()
