"""The conditions under which a dog walks: what differs between a simulation and another day, another
floor, another dog.  A seed decides them."""
import json
import pathlib
import random
import tempfile
import threading
import typing

import openr_host

LEG_JOINTS = [f"{leg}_j{number}" for leg in ("LF", "LH", "RF", "RH") for number in (1, 2, 3)]
LONG_S = 1000  # far more than a dog will walk


class Conditions(typing.NamedTuple):
    """The ranges are chosen; the default run has 0.6, 0, 0 and all motors at 100 %."""

    friction: float              # coefficient of the floor, 0.45 to 0.8
    load_n: float                # weight that the dog carries on its back, 0 to 2 N
    shove_n: float               # a push to the left just before the dog walks, -4 to 4 N for 200 ms
    motors: "dict[str, int]"     # torque of each leg joint, 85 to 100 % of the motor's

    @classmethod
    def of_seed(cls, seed):
        draw = random.Random(seed)
        return cls(round(draw.uniform(0.45, 0.8), 3), round(draw.uniform(0, 2), 2), round(draw.uniform(-4, 4), 2),
                   {joint: draw.randint(85, 100) for joint in LEG_JOINTS})


def standing_dog(seed, program=None):
    """Returns a run in which the dog stands, under the conditions of this seed, ready to walk."""
    conditions = Conditions.of_seed(seed)
    with tempfile.TemporaryDirectory() as folder:
        world = pathlib.Path(folder) / "world.json"
        world.write_text(json.dumps(
            {"schema": "openr-host world 2", "name": f"seed {seed}", "friction": conditions.friction}))
        run = openr_host.Run(world=world, seed=seed, battery="100%", program=program)
    run.until_standing()
    run.run(0.5)
    for joint, percent in conditions.motors.items():
        run.input(f"break {joint} weak {percent}% for {LONG_S}s")
    # The load pushes down at the trunk, and the shove to its left.
    run.input(f"push 0 {conditions.shove_n} {-conditions.load_n} at body for 200ms")
    run.run(0.2)
    run.input(f"push 0 0 {-conditions.load_n} at body for {LONG_S}s")
    run.run(0.3)
    return run


class Kennel:
    """Standing dogs, one for each seed.  Each is made once; what walks are copies of it, which begin
    from the same state and end with their walk."""

    def __init__(self, program):
        self._program = program
        self._dogs = {}
        self._lock = threading.Lock()  # a run answers one request at a time

    def dog(self, seed):
        """Returns a copy of the dog of this seed, to be closed by the caller."""
        with self._lock:
            if seed not in self._dogs:
                self._dogs[seed] = standing_dog(seed, self._program)
            return self._dogs[seed].fork()

    def close(self):
        for run in self._dogs.values():
            run.close()
