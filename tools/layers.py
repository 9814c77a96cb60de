#!/usr/bin/env python3
"""Checks that includes between the folders of the product go one way.

    tools/layers.py [FOLDER]    # FOLDER: the checkout; without it, the one that has this script

Each line of LAYERS is a group: its folders are listed from the lowest to the highest, and a file
may include headers of its own folder, of folders to the left in its group, and of the groups in
MAY_USE.  A header in SDK_HEADERS counts as a header of the folder that defines its functions.  A
file of a folder in ALONE may include only headers of that folder.  Prints every offence as
FILE:LINE; exits with 1 if there is any.

Only the includes of a file itself count, not those of the headers that it includes.  OObject.h, for
example, includes MCOOP.h, so a file of runtime/core could call functions of MCOOP.h unseen.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent

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
# Headers of the SDK (runtime/include) that declare functions, by the folder that defines these
# functions.  All others have types, macros and inline functions only, so every folder may include them;
# gets() of OPENR/CLibrary.h is a function of the C library.
SDK_HEADERS = {
    "runtime/core": "OPENR/OObject.h OPENR/OObserver.h OPENR/OSubject.h OPENR/ObjcommTypes.h OPENR/RCRegion.h",
    "runtime/api": "IPAddress.h IPv4Types.h MCOOP.h ObjectEntryTable.h OPENR/OCalendarTime.h OPENR/ODataFormats.h "
                   "OPENR/OFbkImage.h OPENR/OMemoryLocator.h OPENR/OPENRAPI.h OPENR/OPower.h OPENR/OSyslog.h "
                   "OPENR/OTime.h OPENR/formats/images.h SystemTime.h",
    "runtime/ipstack": "DNSEndpointErr.h DNSEndpointMsg.h ERA201D1.h EtherTypes.h IPEndpointMsg.h TCPEndpointMsg.h "
                       "UDPEndpointMsg.h antEnvBaseMsg.h antEnvInternalMsg.h antEnvMsg.h antErrors.h antModuleRef.h "
                       "antSharedBuffer.h antSharedBufferDef.h antStackRef.h",
}
# Includes of a header in SDK_HEADERS by a file that uses only the header's types.
TYPES_ONLY = [
    ("runtime/core/image_object.h", "ObjectEntryTable.h"),
    ("runtime/core/robot_calls.h", "OPENR/OPENRAPI.h"),
    ("runtime/core/robot_services.h", "OPENR/OPENRAPI.h"),
]
# Libraries that programs outside this project may use: a file there may include only headers of its
# own folder and of objects/common (which are included without a folder), and none of the SDK.
ALONE = ["openr/remote"]
SDK_INCLUDE = re.compile(r'^#include [<"](OPENR|MCOOP|EMOS)/')
INCLUDE = re.compile(r'^#include (?:"((?:%s)/[^"]+)"|[<"]([^>"]+)[>"])' % "|".join(LAYERS))
FOLDER_OF_SDK_HEADER = {header: folder for folder, headers in SDK_HEADERS.items() for header in headers.split()}


def folder_of(path):
    """Returns the folder of LAYERS that contains the file `path`, and the group of that folder."""
    group = path.split("/")[0]
    fitting = [f for f in LAYERS[group].split() if path.startswith(f + "/")]
    return max(fitting, key=len, default=None), group


def folder_of_sdk_header(path, header):
    """Returns what folder_of() returns, for the folder that defines the functions of the SDK's `header`.
    Returns None if every folder may include the header, or if the file `path` uses only its types."""
    if header not in FOLDER_OF_SDK_HEADER or (path, header) in TYPES_ONLY:
        return None
    return folder_of(FOLDER_OF_SDK_HEADER[header] + "/")


def may_include(folder, group, other, other_group):
    """Returns whether files of `folder` may include headers of the folder `other`, which is None if the
    header is in no folder of LAYERS."""
    if other is None or folder in ALONE:
        return other == folder
    if other_group != group:
        return other_group in MAY_USE[group]
    order = LAYERS[group].split()
    return order.index(other) <= order.index(folder)


def offences(path):
    """Yields a line of text for each include of the file `path` that LAYERS does not allow."""
    folder, group = folder_of(path)
    if folder is None:
        yield f"{path}: its folder is not in LAYERS of tools/layers.py"
        return
    for number, line in enumerate((ROOT / path).read_text().splitlines(), 1):
        include = INCLUDE.match(line)
        if not include:
            continue
        header, sdk_header = include.groups()
        if folder in ALONE and SDK_INCLUDE.match(line):
            yield f"{path}:{number}: {folder} may not include headers of the SDK"
            continue
        found = folder_of(header) if header else folder_of_sdk_header(path, sdk_header)
        if found and not may_include(folder, group, *found):
            why = f", whose functions are in {found[0]}" if sdk_header else ""
            yield f"{path}:{number}: {folder} may not include {header or sdk_header}{why}"


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
