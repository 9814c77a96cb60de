#!/usr/bin/env python3
"""Reads AIBO_1.1 log files, as a second reader that shares nothing with the program.

Written from the text of Hohl 2004, section 3.3.6 with tables 3.9 and 3.10, and from nothing else:

  header   8 characters, AIBO_1.1; then a series of key frames
  key frame
    1 short                    MTN key frame
    15 short                   commanded positions
    1 byte                     number of measured values, 0 or 19
    0 or 19 short              measured: 15 positions, 4 paws
    1 byte                     number of simulated values, 0 or 19
    0 or 19 short              simulated: 15 positions, 4 paws
  little-endian; positions in 10^-2 degrees, paws 1 (on) or 0 (off)

Prints one line for each key frame: its number, then the three groups in degrees, a group without
values as "-".  usage: read_aibo_log.py FILE
"""
import struct
import sys

JOINTS, PAWS = 15, 4


def group(data, at):
    """The values of the group whose count is at the offset `at`, and the offset behind it."""
    count = data[at]
    at += 1
    if count == 0:
        return "-", at
    if count != JOINTS + PAWS:
        sys.exit(f"offset {at - 1}: {count} values")
    values = struct.unpack_from("<19h", data, at)
    paws = values[JOINTS:]
    if any(paw not in (0, 1) for paw in paws):
        sys.exit(f"offset {at}: paws {paws}")
    text = " ".join(f"{v / 100:.2f}" for v in values[:JOINTS]) + " paws " + "".join(map(str, paws))
    return text, at + 2 * count


def main():
    with open(sys.argv[1], "rb") as file:
        data = file.read()
    if data[:8] != b"AIBO_1.1":
        sys.exit("offset 0: no AIBO_1.1")
    at = 8
    while at < len(data):
        key_frame, *commanded = struct.unpack_from("<16h", data, at)
        measured, at = group(data, at + 32)
        simulated, at = group(data, at)
        print(f"{key_frame} commanded", " ".join(f"{v / 100:.2f}" for v in commanded),
              "measured", measured, "simulated", simulated)


if __name__ == "__main__":
    main()
