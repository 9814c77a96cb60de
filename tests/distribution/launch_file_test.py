#!/usr/bin/env python3
"""The run that examples/ros2/aibo.launch.py starts, for both middlewares of ROS 2.

    launch_file_test.py --build BUILD

ROS 2 is not needed: stand-ins for its launch modules keep what the file asks for.  The command of the
run is executed with a second of virtual time.  Without Cyclone DDS the test is skipped.
The last line is "N passed, N failed", or with ", N skipped".
"""
import argparse
import os
import runpy
import subprocess
import sys
import tempfile
import types
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
from verdicts import finish, verdict  # noqa: E402

LAUNCH_FILE = ROOT / "examples/ros2/aibo.launch.py"
# No other test uses these domains (tests/distribution/ros2/ros2_run.h).
DOMAINS = {"rmw_cyclonedds_cpp": "78", "rmw_fastrtps_cpp": "79"}
# Ends the run soon, and keeps it apart from other tests on this machine.
SHORT_RUN = ["--for", "1s", "--rate", "max", "--rc-port", "0", "--no-panel", "--console", "/dev/null"]
LIMIT_S = 120


class StandIn:
    """Any class of the launch modules: keeps its name and arguments."""

    def __init__(self, kind, *words, **named):
        self.kind, self.words, self.named = kind, words, named

    def perform(self, values):
        """Returns the value of a LaunchConfiguration."""
        return values[self.words[0]]


def stand_in_module(name):
    """Returns a module that has every class, each as a StandIn of that name."""
    module = types.ModuleType(name)
    module.__path__ = []
    module.__getattr__ = lambda kind: lambda *words, **named: StandIn(kind, *words, **named)
    return module


def launched(values):
    """Returns the actions of the launch file and its arguments, which `values` overrides."""
    for name in ("launch", "launch.actions", "launch.substitutions", "launch_ros", "launch_ros.actions"):
        sys.modules[name] = stand_in_module(name)
    file = runpy.run_path(str(LAUNCH_FILE))
    entities = file["generate_launch_description"]().words[0]
    arguments = {one.words[0]: one.named["default_value"] for one in entities
                 if one.kind == "DeclareLaunchArgument"}
    arguments.update(values)
    start = next(one.named["function"] for one in entities if one.kind == "OpaqueFunction")
    return start(arguments), arguments


def check(rmw, domain):
    """Checks the launch file for one middleware.  Returns False if Cyclone DDS is not there."""
    actions, arguments = launched({"rmw": rmw, "domain": domain})
    command = next(one.named["cmd"] for one in actions if one.kind == "ExecuteProcess")
    environment = {one.words[0]: one.words[1] for one in actions if one.kind == "SetEnvironmentVariable"}
    ended = subprocess.run(command + SHORT_RUN, env={**os.environ, **environment}, text=True,
                           capture_output=True, timeout=LIMIT_S, stdin=subprocess.DEVNULL)
    if "libddsc" in ended.stderr and "cannot be loaded" in ended.stderr:
        return False
    verdict(f"{rmw}: the run has topics until its time is over",
            ended.returncode == 0 and f"ROS 2: topics of /aibo in DDS domain {domain}" in ended.stderr,
            " ".join(command) + "\n" + ended.stderr)
    verdict(f"{rmw}: ROS 2 has the middleware and the domain of the run",
            environment["RMW_IMPLEMENTATION"] == rmw and environment["ROS_DOMAIN_ID"] == domain,
            str(environment))
    node = next(one for one in actions if one.kind == "Node")
    description = node.named["parameters"][0]["robot_description"]
    verdict(f"{rmw}: robot_state_publisher has the description of the robot",
            "<robot name=" in description and arguments["model"] == "ers210", description[:200])
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=Path)
    build = parser.parse_args().build.resolve()
    os.environ["PATH"] = f"{build / 'bin'}:{os.environ['PATH']}"
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.environ["HOME"] = folder
        os.chdir(folder)  # the launch file writes settings of DDS to the working folder
        has_dds = all(check(rmw, domain) for rmw, domain in DOMAINS.items())
        os.chdir(before)
    if not has_dds:
        print("Cyclone DDS is not here, so no run has topics")
        print("0 passed, 0 failed, 1 skipped")
        return 0
    return finish()


if __name__ == "__main__":
    sys.exit(main())
