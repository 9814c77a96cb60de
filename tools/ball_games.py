#!/usr/bin/env python3
"""Lets examples/BallChaser play, and prints how often it reaches the ball and scores.

    ball_games.py --build DIR [--games reach,score,match] [--seeds N] [--matches N] [--jobs N]
    ball_games.py --build DIR --pictures FOLDER

reach: the ball lies 1 m from the dog, anywhere in front of it; 30 s.
score: the ball lies 1 m from the goal; 90 s.
match: two dogs against two; five minutes without an error finding, and a ball in a goal at the end.

All happens on the field of 2004, with physics, the camera that draws the world, and the default
servo.  The seed decides where the ball lies, and in matches the dogs.  The exit status is 1 unless
reach succeeds in 18 of 20 games, score in 12 of 20 and match in 5 of 10, or as large a share of
fewer.  A game ends with its time, so a ball counts as scored if it is in the goal then.

With --pictures, the program writes pictures of the first match to the folder: match.png, and
robots-view.png, which is what a dog sees.
"""
import argparse
import concurrent.futures
import json
import math
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FIELD = ROOT / "virtualrobot/worlds/field-2004.json"
GOAL_X, GOAL_HALF = 2.1, 0.3  # m: the goal lines, and half of a goal's width
SHARES = {"reach": 18 / 20, "score": 12 / 20, "match": 5 / 10}


class Game:
    """A game: the places at its beginning, how long it lasts, and what counts as success."""

    def __init__(self, kind, seed):
        draw = random.Random(f"{kind} {seed}")
        self.kind, self.seed = kind, seed
        self.starts = [(0, 0, 0)]  # x and y in m, and degrees
        if kind == "reach":
            angle = math.radians(draw.uniform(-80, 80))
            self.seconds, self.ball = 30, (math.cos(angle), math.sin(angle))
        elif kind == "score":
            angle = math.radians(draw.uniform(-60, 60))
            self.seconds, self.ball = 90, (GOAL_X - math.cos(angle), math.sin(angle))
        else:
            self.seconds, self.ball = 300, (0, draw.uniform(-0.3, 0.3))
            self.starts = [(-0.6, 0.4, 0), (draw.uniform(-0.9, -0.5), -0.5, 0),
                           (0.6, -0.4, 180), (draw.uniform(0.5, 0.9), 0.5, 180)]

    def world(self):
        world = json.loads(FIELD.read_text())
        ball = next(thing for thing in world["things"] if thing["name"] == "ball")
        ball["centre_m"][:2] = self.ball
        if len(self.starts) > 1:
            world["starts"] = [{"place_m": [x, y], "yaw_deg": yaw} for x, y, yaw in self.starts]
        return world

    def judge(self, ball, errors):
        """Returns whether the game succeeded, for the ball's place at its end."""
        x, y = ball
        is_scored = abs(x) > GOAL_X and abs(y) < GOAL_HALF
        if self.kind == "reach":
            return math.dist(ball, self.ball) > 0.005 and not errors
        if self.kind == "score":
            return is_scored and x > 0 and not errors
        return is_scored and not errors


def make_stick(openr, folder, goal):
    """Builds the example in `folder`, for a dog that plays at the goal of this colour."""
    shutil.copytree(ROOT / "examples/BallChaser", folder, ignore=shutil.ignore_patterns("OBJS"))
    (folder / "MS/OPEN-R/MW/CONF/PLAYER.CFG").write_text(goal + "\n")
    subprocess.run([openr, "build", str(folder), "-j", "1"], check=True, stdout=subprocess.DEVNULL)
    return folder / "MS"


def run_game(openr, sticks, game, folder, seconds, flags):
    """Runs the dogs of a game, with these flags more, and returns the finished process."""
    world = folder / f"{game.kind}-{game.seed}.json"
    world.write_text(json.dumps(game.world()))
    flags = ["--stick", str(sticks[0]), *flags]
    if len(game.starts) > 1:
        flags += ["--stick", str(sticks[0]), "--stick", str(sticks[1]), "--stick", str(sticks[1]),
                  "--robots", str(len(game.starts)), "--together"]
    return subprocess.run(
        [openr, "run", *flags, "--world", str(world), "--seed", str(game.seed), "--for",
         f"{seconds}s", "--rate", "max", "--no-panel", "--rc-port", "0", "--json"],
        capture_output=True, text=True)


def play(openr, sticks, game, folder):
    """Returns the line of the table for a game, and whether it succeeded."""
    run = run_game(openr, sticks, game, folder, game.seconds, [])
    if run.returncode not in (0, 1) or not run.stdout:
        raise RuntimeError(f"{game.kind} {game.seed}: {run.stderr}")
    report = json.loads(run.stdout)
    if "error" in report:
        raise RuntimeError(f"{game.kind} {game.seed}: {report['error']}")
    errors = [f["text"] for f in report["findings"] if f["severity"] == "error"]
    things = report["robots"][0]["things"]
    ball = next(thing["position_m"][:2] for thing in things if thing["name"] == "ball")
    good = game.judge(ball, errors)
    line = (f"{game.kind} {game.seed:3}  ball {game.ball[0]:5.2f} {game.ball[1]:5.2f} -> "
            f"{ball[0]:5.2f} {ball[1]:5.2f}  {'good' if good else 'no'}")
    return line + "".join(f"\n    {error}" for error in errors), good


def take_pictures(openr, sticks, folder, to):
    seconds = 12  # all dogs are at the ball
    flags = ["--snapshot", "view=iso,size=960x540", "-o", str(to / "match.png"),
             "--snapshot", "view=camera", "-o", str(to / "robots-view.png")]
    run = run_game(openr, sticks, Game("match", 1), folder, seconds, flags)
    if run.returncode != 0:
        raise RuntimeError(run.stderr)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--games", default="reach,score,match")
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--matches", type=int, default=10)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--pictures", type=pathlib.Path)
    arguments = parser.parse_args()
    openr = str((arguments.build / "bin/openr").resolve())
    failed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        sticks = [make_stick(openr, folder / goal, goal) for goal in ("SKY-BLUE", "YELLOW")]
        if arguments.pictures:
            take_pictures(openr, sticks, folder, arguments.pictures)
            return 0
        for kind in arguments.games.split(","):
            count = arguments.matches if kind == "match" else arguments.seeds
            games = [Game(kind, seed) for seed in range(1, count + 1)]
            with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
                results = list(pool.map(lambda game: play(openr, sticks, game, folder), games))
            for line, _ in results:
                print(line)
            good = sum(good for _, good in results)
            is_enough = good >= SHARES[kind] * count
            failed += not is_enough
            print(f"{kind}: {good} of {count}{'' if is_enough else ', too few'}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
