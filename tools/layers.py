#!/usr/bin/env python3
"""Checks that includes between the folders of the product go one way.

Each line of LAYERS is a group: its folders are listed from the lowest to the highest, and a file
may include headers of its own folder, of folders to the left in its group, and of the groups in
MAY_USE.  A file of a folder in ALONE may include only headers of that folder.  Prints every
offence as FILE:LINE; exits with 1 if there is any.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

LAYERS = {
    "runtime": "runtime/base runtime/config runtime/stick runtime/core runtime/api "
               "runtime/ipstack runtime/gateway runtime/hooks",
    "virtualrobot": "virtualrobot/base virtualrobot/model virtualrobot/worlds virtualrobot/body virtualrobot/dynamics virtualrobot/ode "
                    "virtualrobot/vectors virtualrobot/devices virtualrobot/power virtualrobot/camera virtualrobot/sound "
                    "virtualrobot/robot virtualrobot/comm virtualrobot",
    "distribution": "distribution",
    "cli": "cli",
    "kit": "kit",
    "openr": "openr/ending openr/emon openr/decode openr/simulation openr/model openr/graph openr/chart openr/motion openr/remote "
             "openr/pair openr/controller openr/upload openr/render openr/explore openr/timeline openr/inspect openr/data "
             "openr/rewind openr/live openr/panel openr/run openr/serve openr/ros2 openr/commands openr",
    "testing": "testing",
}
MAY_USE = {
    "runtime": [],
    "virtualrobot": ["runtime"],
    "distribution": ["runtime"],
    "cli": ["runtime"],
    "kit": ["runtime", "cli"],
    "openr": ["runtime", "virtualrobot", "distribution", "cli", "kit"],
    "testing": ["runtime", "virtualrobot", "cli", "openr"],
}
# Libraries that programs outside this project may use: a file there may include only headers of its
# own folder and of objects/common (which are included without a folder), and none of the SDK.
ALONE = ["openr/remote"]
SDK_INCLUDE = re.compile(r'^#include [<"](OPENR|MCOOP|EMOS)/')
INCLUDE = re.compile(r'^#include "((?:%s)/[^"]+)"' % "|".join(LAYERS))


def folder_of(path):
    """Returns the folder of LAYERS that contains the file `path`, and the group of that folder."""
    group = path.split("/")[0]
    fitting = [f for f in LAYERS[group].split() if path.startswith(f + "/")]
    return max(fitting, key=len, default=None), group


def offences(path):
    """Yields a line of text for each include of the file `path` that LAYERS does not allow."""
    folder, group = folder_of(path)
    if folder is None:
        yield f"{path}: its folder is not in LAYERS of tools/layers.py"
        return
    order = LAYERS[group].split()
    for number, line in enumerate((ROOT / path).read_text().splitlines(), 1):
        include = INCLUDE.match(line)
        if folder in ALONE and SDK_INCLUDE.match(line):
            yield f"{path}:{number}: {folder} may not include headers of the SDK"
        if not include:
            continue
        other, other_group = folder_of(include[1])
        if other is None or (folder in ALONE and other != folder) or (
            order.index(other) > order.index(folder)
            if other_group == group
            else other_group not in MAY_USE[group]
        ):
            yield f"{path}:{number}: {folder} may not include {include[1]}"


def main():
    found = []
    for group in LAYERS:
        for path in sorted((ROOT / group).rglob("*")):
            name = path.relative_to(ROOT).as_posix()
            outside = name.startswith(("runtime/include/", "runtime/compat/", "kit/controller/"))
            if path.suffix in (".h", ".cc") and not outside:
                found += offences(name)
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
