#!/usr/bin/env python3
"""openr emon, with the crash of a MIPS program that runs under qemu.

    emon_test.py --build BUILD

The registers and the stack are those of the crash.  The record has the parts of the robot's record
(field-notes.md 4.5) and other addresses than the file, as if the robot had loaded the image
elsewhere.  The last line is "N passed, N failed".
"""
import argparse
import gzip
import json
import re
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from verdicts import finish, verdict  # noqa: E402

SOURCE = Path(__file__).resolve().parent / "emon/crash.cc"
SHIFT = 0x22200000  # the robot's addresses less those of the file
LINKED_AT = 0x400000
REGISTERS = {28: "gp", 29: "sp", 31: "ra"}


def compile_program(folder):
    program = folder / "DANCER.elf"
    subprocess.run(["mipsel-linux-gnu-g++", "-g", "-O1", "-fPIC", "-static", "-no-pie", "-march=mips2",
                    f"-Wl,-Ttext-segment={LINKED_AT:#x}", SOURCE, "-o", program], check=True)
    return program


def code_of(program):
    """Returns the first address of the code and the one after it."""
    sections = subprocess.run(["mipsel-linux-gnu-readelf", "-SW", program], check=True, text=True,
                              capture_output=True).stdout
    begin, size = re.search(r" \.text +PROGBITS +(\w+) \w+ (\w+)", sections).groups()
    return int(begin, 16), int(begin, 16) + int(size, 16)


def number_of_text(program):
    sections = subprocess.run(["mipsel-linux-gnu-readelf", "-SW", program], check=True, text=True,
                              capture_output=True).stdout
    return int(re.search(r"\[ *(\d+)\] \.text ", sections)[1])


def record(program, shift):
    """Lets the program crash; returns its record as the robot would write it."""
    text = subprocess.run(["qemu-mipsel-static", program], check=True, capture_output=True,
                          text=True).stdout
    begin, end = code_of(program)

    def moved(value):
        return value + shift if begin <= value < end else value

    registers = {name: int(value, 16) for name, value in re.findall(r"^(\w+) (\w+)$", text, re.M)}
    stack = [(int(at, 16), int(value, 16)) for at, value in
             re.findall(r"^stack (\w+) (\w+)$", text, re.M)]
    registers["r28"] += shift
    lines = ["mCOOP exception", "[exception info]", " status:$12: 0x0000ff13, cause:$13: 0x00000008",
             f" badvaddr: $8: {registers['badvaddr']:#010x}, epc:$14: {moved(registers['epc']):#010x}",
             "[object info]", " context: 0x80410000, state: 0x00000001", "[register dump]"]
    lines += [f" {REGISTERS.get(i, 'x')}:r{i}: {moved(registers[f'r{i}']):#010x}" for i in range(32)]
    lines += ["[object list]", " Name Context Thread OID MetaSpace",
              " dancer 0x80410000 0x80410100 0x80000051 mCOOP", "[stack dump]"]
    lines += [f"{at:08x}: {moved(value):08x}  1234" for at, value in stack]
    return "\r\n".join(lines) + "\r\n"


def move_headers(program, image):
    """Makes a .BIN: without names, with the addresses of its headers moved to 0, compressed."""
    stripped = image.with_suffix(".tmp")
    subprocess.run(["mipsel-linux-gnu-strip", "-o", stripped, program], check=True)
    data = bytearray(stripped.read_bytes())
    stripped.unlink()
    programs, sections = struct.unpack_from("<II", data, 28)
    program_bytes, program_count, section_bytes, section_count = struct.unpack_from("<4H", data, 42)
    places = [programs + program_bytes * i + 8 for i in range(program_count)]
    places += [sections + section_bytes * i + 12 for i in range(section_count)]
    for place in places:
        address = struct.unpack_from("<I", data, place)[0]
        if address >= LINKED_AT:
            struct.pack_into("<I", data, place, address - LINKED_AT)
    image.write_bytes(gzip.compress(bytes(data)))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=Path)
    openr = parser.parse_args().build.resolve() / "bin/openr"
    crash_line = next(number for number, line in enumerate(SOURCE.read_text().splitlines(), 1)
                      if "crashes here" in line)
    with tempfile.TemporaryDirectory(prefix="openr-emon-test-") as name:
        folder = Path(name)
        program = compile_program(folder)
        log = folder / "EMON.LOG"
        log.write_text(record(program, SHIFT))

        def emon(*arguments):
            done = subprocess.run([openr, "emon", log, *arguments], capture_output=True, text=True)
            return done.returncode, done.stdout + done.stderr

        def check(what, image):
            status, said = emon("--image", image, "--json")
            answer = json.loads(said) if status == 0 else {}
            place = answer.get("place", {})
            verdict(f"{what}: the line of the crash",
                    place.get("line") == f"crash.cc:{crash_line}" and "Dancer::Step" in place["function"],
                    said)
            callers = [call["function"] for call in answer.get("calls", [])]
            verdict(f"{what}: its callers",
                    [c.split("(")[0] for c in callers[:2]] == ["Dancer::Notify", "main"], callers)

        check("an ELF file", program)
        image = folder / "DANCER.BIN"
        move_headers(program, image)
        check("a .BIN with the ELF file beside it", image)
        status, said = emon("--image", image)
        verdict("as text", status == 0 and "EXCEPTION 2: a load, or a jump" in said
                and "OBJECT dancer (OID 0x80000051, mCOOP)" in said
                and f"Dancer::Step(int const*) (crash.cc:{crash_line})" in said, said)
        program.rename(folder / "away")
        status, said = emon("--image", image)
        verdict("a .BIN alone says what is missing",
                status == 0 and "has no names of functions" in said and " in the image" in said, said)
        program = folder / "away"
        other = bytearray(program.read_bytes())
        sections, = struct.unpack_from("<I", other, 32)
        struct.pack_into("<I", other, sections + 40 * number_of_text(program) + 20, 64)
        (folder / "DANCER.elf").write_bytes(other)
        status, said = emon("--image", image)
        verdict("the ELF file of another build gives no names",
                status == 0 and "has no names of functions" in said, said)
        log.write_text(record(program, SHIFT).replace("gp:r28", "x:x28"))
        status, said = emon("--image", image)
        verdict("without gp", status == 0 and "has no register gp" in said, said)
    return finish()


if __name__ == "__main__":
    sys.exit(main())
