#!/usr/bin/env python3
"""Finds a fast walk for the simulated dog, and writes it as motion files.

    find_walk.py -o FOLDER [--minutes 10] [--jobs 2] [--at-least 1.5]

The module openr_host is installed, or PYTHONPATH names the folder that holds it.

With --generations N the search ends after so many generations, not by the clock, so it does the same
work and finds the same walk on each machine.

The search begins with the walk of the default stick.  Its joints are sums of waves, whose sizes are
the numbers that evolve: each generation draws gaits around the best ones so far (an evolution
strategy with one step size for each number).  Each gait becomes a motion file, is uploaded to the
dog, played through its remote control on the body with physics, and measured.  A gait keeps the
limits of angle and speed of all joints, or is no candidate.

FOLDER gets GOSTA.MTN, which leads from standing to the walk, GO.MTN, a cycle of it, curve.svg, the
learning curve, and walk.json, the result.

A seed decides the conditions of a dog (conditions.py): the floor's friction, a load, a shove before
it walks, the torque of each motor.  A gait is worth what it is worth under the worst of the
conditions of three seeds, which each generation draws from eight, so that no gait fits three dogs
only.  The best gaits of all generations then walk longer, under the conditions of six more seeds,
and the best of these wins.  At the end the winner and the walk of the default stick are played under
the conditions of three other seeds, which neither the search nor the choice has seen.

The last line says how fast the winner is.  The exit status is 1 if it is slower, under one of these
three seeds, than 1.5 times the walk of the default stick (--at-least), or if it is not upright,
straight and within the limits.
"""
import argparse
import itertools
import json
import math
import pathlib
import random
import sys
import time

import openr_host
from openr_host._channel import find_program

from conditions import Conditions, Kennel
from curve import write_curve
from gait import Gait, csv_of, dump, is_within_speed, play_and_measure, way

SEARCH_SEEDS, SEEDS_AT_A_TIME = range(1, 9), 3
CHOICE_SEEDS = range(11, 17)
UNSEEN_SEEDS = (101, 102, 103)
SEARCH_S, CHECK_S = 5.0, 15.0  # how long a gait walks in the search, and in the choice and the check
SEARCH_SHARE = 0.95  # share of the time that the search takes; the choice takes the rest
FINALISTS = 16
NECK = ("neck_tilt", "neck_pan", "neck_roll")
UNFIT = -200.0  # score of a gait that cannot be played, or lets the dog fall


def files_of(gait, run):
    """Returns the two motion files of a gait; None if its joints would be too fast."""
    targets = run.targets()
    cycle = gait.cycle(run.limits)
    if cycle is None:
        return None
    stand = {name: targets[name] for name in cycle[0]}
    neck = {name: targets[name] for name in NECK}
    start = way(stand, cycle[0], run.limits)
    return (run.motion(csv_of(start, run, neck), "stand#go"), run.motion(csv_of(cycle, run, neck), "go#go"))


def score(walk, seconds):
    """Returns how good a walk of this many seconds is: its speed in mm/s, less what makes it unfit."""
    if walk is None:
        return UNFIT
    # A dog that turns drifts the more the longer it walks.  So a shorter walk may drift less: 2 % in
    # 5 s, 6 % in 15 s, where 10 % are allowed.
    over = max(0.0, walk.drift - 0.004 * seconds) * 1000 + max(0.0, walk.tilt_deg - 15) * 5
    return walk.speed_mm_s - over - 100 * walk.errors


def judge(kennel, gait, seeds, seconds):
    """Returns the score of a gait under the worst of the conditions of these seeds."""
    worst, files = math.inf, None
    for seed in seeds:
        try:
            with kennel.dog(seed) as run:
                files = files or files_of(gait, run)
                worst = min(worst, score(play_and_measure(run, *files, seconds), seconds) if files else UNFIT)
        except (openr_host.NotMet, openr_host.RunEnded, openr_host.RemoteError, ValueError):
            return UNFIT
        if worst <= UNFIT:
            break
    return worst


class Strategy:
    """An evolution strategy with one step size for each number (separable CMA-ES)."""

    def __init__(self, mean, steps, size, generator):
        self.mean, self.steps, self.size, self.random = list(mean), list(steps), size, generator
        count, self.parents = len(mean), size // 2
        raw = [math.log(self.parents + 0.5) - math.log(i + 1) for i in range(self.parents)]
        self.weights = [each / sum(raw) for each in raw]
        self.mass = 1 / sum(each * each for each in self.weights)
        self.c_sigma = (self.mass + 2) / (count + self.mass + 3)
        self.damping = 1 + self.c_sigma
        self.c_c = 4 / (count + 4)
        self.c_cov = min(0.5, (count + 2) / 3 * (2 / ((count + 1.3) ** 2 + self.mass)) * 2)
        self.sigma, self.variance = 1.0, [1.0] * count
        self.path_sigma, self.path_c = [0.0] * count, [0.0] * count
        self.norm = math.sqrt(count) * (1 - 1 / (4 * count) + 1 / (21 * count * count))

    def draw(self):
        """Returns the deviations of a generation, each a list of numbers."""
        return [[self.random.gauss(0, 1) for _ in self.mean] for _ in range(self.size)]

    def at(self, deviation):
        return [mean + self.sigma * step * math.sqrt(variance) * z for mean, step, variance, z in
                zip(self.mean, self.steps, self.variance, deviation)]

    def learn(self, deviations, scores):
        """Moves the mean towards the best, and adapts the steps."""
        order = sorted(range(self.size), key=lambda i: -scores[i])[:self.parents]
        z = [sum(weight * deviations[i][k] for weight, i in zip(self.weights, order))
             for k in range(len(self.mean))]
        self.mean = self.at(z)
        rate = math.sqrt(self.c_sigma * (2 - self.c_sigma) * self.mass)
        self.path_sigma = [(1 - self.c_sigma) * p + rate * each for p, each in zip(self.path_sigma, z)]
        length = math.sqrt(sum(p * p for p in self.path_sigma))
        rate = math.sqrt(self.c_c * (2 - self.c_c) * self.mass)
        for k, each in enumerate(z):
            y = math.sqrt(self.variance[k]) * each
            self.path_c[k] = (1 - self.c_c) * self.path_c[k] + rate * y
            spread = sum(weight * self.variance[k] * deviations[i][k] ** 2
                         for weight, i in zip(self.weights, order))
            self.variance[k] = ((1 - self.c_cov) * self.variance[k] + self.c_cov / self.mass
                                * self.path_c[k] ** 2 + self.c_cov * (1 - 1 / self.mass) * spread)
        self.sigma *= math.exp(self.c_sigma / self.damping * (length / self.norm - 1))


def limits_of(generations, minutes):
    """Returns how many generations and how many seconds a search may take.  `minutes` is None if
    the user has not said how long."""
    if generations and minutes is None:
        return generations, math.inf
    return generations or math.inf, 60 * SEARCH_SHARE * (10 if minutes is None else minutes)


def search(kennel, shipped, arguments):
    """Returns the best gait of each generation with its score, the mean of the last generation among
    them, and the curve: for each generation seconds, best score, mean score."""
    waves = len(shipped.numbers)  # the logarithm of the cycle's length follows these numbers
    generator = random.Random(arguments.seed)
    strategy = Strategy([*shipped.numbers, math.log(shipped.frames)], [4.0] * waves + [0.15],
                        arguments.population, generator)

    def gait_of(numbers):
        frames = round(math.exp(min(4.2, max(2.7, numbers[-1]))))
        return Gait(numbers[:-1], frames)

    tops, curve, begin = [], [], time.monotonic()
    generations, seconds = limits_of(arguments.generations, arguments.minutes)
    for generation in itertools.count():
        if generation >= generations or time.monotonic() - begin > seconds:
            break
        seeds = generator.sample(SEARCH_SEEDS, SEEDS_AT_A_TIME)
        deviations = strategy.draw()
        gaits = [gait_of(strategy.at(each)) for each in deviations]
        scores = openr_host.parallel(lambda gait: judge(kennel, gait, seeds, SEARCH_S), gaits, arguments.jobs)
        strategy.learn(deviations, scores)
        top = max(range(len(gaits)), key=lambda i: scores[i])
        tops.append((scores[top], gaits[top]))
        alive = [each for each in scores if each > UNFIT]
        curve.append((time.monotonic() - begin, scores[top], sum(alive) / max(1, len(alive))))
        if generation % 10 == 0:
            print(f"{curve[-1][0]:6.0f} s, generation {generation}: best {scores[top]:.1f} mm/s, step "
                  f"{strategy.sigma:.2f}", file=sys.stderr, flush=True)
    if tops:
        tops.append((max(top for top, _ in tops), gait_of(strategy.mean)))
    return tops, curve


def choose(kennel, shipped, tops, jobs):
    """Returns the gait that walks best under the conditions of further seeds, its score, and the
    score of the shipped one, which is chosen if none is better."""
    finalists = [gait for _, gait in sorted(tops, key=lambda top: -top[0])[:FINALISTS]]
    gaits = [shipped, *finalists]
    scores = openr_host.parallel(lambda gait: judge(kennel, gait, CHOICE_SEEDS, CHECK_S), gaits, jobs)
    best = max(range(len(gaits)), key=lambda i: scores[i])
    return gaits[best], scores[best], scores[0]


def check(kennel, start, cycle, seeds):
    """Plays two motion files under the conditions of each seed, and returns how the dogs have walked."""
    walks = []
    for seed in seeds:
        with kennel.dog(seed) as run:
            walks.append(play_and_measure(run, start, cycle, CHECK_S))
    return walks


def keeps_limits(program, files, run):
    """Returns whether all key frames of motion files keep the limits of angle and speed."""
    names = {locator: name for name, locator in run.locators.items()}
    for file in files:
        poses = [{names[locator]: value for locator, value in frame.items()}
                 for frame in dump(program, file)]
        inside = all(run.limits[name][0] <= value <= run.limits[name][1]
                     for pose in poses for name, value in pose.items())
        if not inside or not is_within_speed(poses, run.limits):
            return False
    return True


def verdict(result, at_least):
    """Returns the last line that the script prints, and its exit status."""
    is_fast = result["times_as_fast"] >= at_least
    said = {True: "yes", False: "no"}
    line = (f"{result['slowest_mm_s']:.1f} mm/s, {result['times_as_fast']:.2f} times the walk of the stick "
            f"({result['shipped_mm_s']:.1f} mm/s); at least {at_least:g} times: {said[is_fast]}; "
            f"upright, straight and within limits: {said[result['good']]}")
    return line, 0 if is_fast and result["good"] else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--minutes", type=float, help="how long to search (10; with --generations no limit)")
    parser.add_argument("--at-least", type=float, default=1.5, metavar="TIMES",
                        help="status 1 if the winner is not so many times as fast as the walk of the stick (1.5)")
    parser.add_argument("--generations", type=int, default=0, help="end after so many; 0: by time (0)")
    parser.add_argument("--population", type=int, default=16)
    parser.add_argument("--jobs", type=int, default=2, help="candidates at a time (2)")
    parser.add_argument("--seed", type=int, default=1, help="seed of the search (1)")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    program = find_program()
    shipped_files = [openr_host.default_motion(name) for name in ("WALKSTA.MTN", "WALK.MTN")]
    kennel = Kennel(program)
    with kennel.dog(UNSEEN_SEEDS[0]) as run:
        shipped = Gait.of_cycle(dump(program, shipped_files[1]), run.locators)
        tops, curve = search(kennel, shipped, arguments)
        best, best_score, begun = choose(kennel, shipped, tops, arguments.jobs)
        files = [arguments.output / name for name in ("GOSTA.MTN", "GO.MTN")]
        for file, data in zip(files, files_of(best, run)):
            file.write_bytes(data)
        is_kept = keeps_limits(program, files, run)
    old = check(kennel, *(file.read_bytes() for file in shipped_files), UNSEEN_SEEDS)
    new = check(kennel, *(file.read_bytes() for file in files), UNSEEN_SEEDS)
    kennel.close()
    shipped_mm_s = sum(walk.speed_mm_s for walk in old) / len(old)
    write_curve(arguments.output / "curve.svg", curve, shipped_mm_s)
    is_good = is_kept and all(walk is not None and walk.is_good() for walk in new)
    slowest = min(walk.speed_mm_s if walk else 0 for walk in new)
    result = {"shipped_mm_s": shipped_mm_s, "begun_mm_s": begun, "search_mm_s": best_score, "generations": len(curve),
              "conditions": {seed: Conditions.of_seed(seed)._asdict() for seed in UNSEEN_SEEDS},
              "walks": [walk and walk._asdict() for walk in new],
              "shipped_walks": [walk and walk._asdict() for walk in old],
              "slowest_mm_s": slowest, "times_as_fast": slowest / shipped_mm_s,
              "keeps_limits": is_kept, "good": is_good, "cycle_frames": best.frames,
              "numbers": best.numbers}
    (arguments.output / "walk.json").write_text(json.dumps(result, indent=1) + "\n")
    line, status = verdict(result, arguments.at_least)
    print(line)
    return status


if __name__ == "__main__":
    sys.exit(main())
