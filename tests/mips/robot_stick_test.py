#!/usr/bin/env python3
"""openr stick robot, with an SDK made here of Debian's cross compiler and small scripts.

    robot_stick_test.py --build BUILD

It proves that the sources an installation has are complete, compile for MIPS as the command calls
the compiler, that the stick is assembled as it should be, and what is refused.  It does not prove
that Sony's compiler and mkbin take them: mkbin is a script here that joins the object files.
The last line is "N passed, N failed".
"""
import argparse
import gzip
import os
import re
import shutil
import stat
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from verdicts import finish, verdict  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent.parent

CCACHE = shutil.which("ccache") or ""
GXX = """#!/bin/sh
exec {ccache} mipsel-linux-gnu-{tool} {standard} -march=mips2 "$@"
"""
# As the core reference, 5.5, gives its command line; refuses what the real one would not know.
MKBIN = """#!/bin/sh
set -e
objects=
while [ $# -gt 0 ]; do
  case $1 in
    -p) [ -d "$2/OPEN_R" ] || { echo "mkbin: $2: no SDK" >&2; exit 1; }; shift ;;
    -o) out=$2; shift ;;
    *.ocf) ocf=$1 ;;
    *.o) objects="$objects $1" ;;
    -L*|-lObjectComm|-lOPENR|-lInternet|-lantMCOOP) libraries="$libraries $1" ;;
    *) echo "mkbin: what is $1?" >&2; exit 1 ;;
  esac
  shift
done
grep -q '^object' "$ocf"
echo "$(basename "$out"):$libraries" >>"$FAKE_LOG"
mipsel-linux-gnu-ld -EL -r -o "${out%.*}.nosnap.elf" $objects
exec mipsel-linux-gnu-strip --strip-debug -o "$out" "${out%.*}.nosnap.elf"
"""
TEMPLATE = "# template\r\n\r\n"
BASE_FILES = {
    "OPEN-R/APERIOS.GZ": "kernel",
    "OPEN-R/VERSION.txt": "1",
    "OPEN-R/SYSTEM/CONF/WLANDFLT.TXT": "ESSID=AIBONET\r\n",
    "OPEN-R/SYSTEM/OBJS/VR.BIN": "system",
    "OPEN-R/MW/CONF/DESIGN.CFG": "0001.0001.*-6\r\n",
    "OPEN-R/MW/CONF/OBJECT.CFG": TEMPLATE,
    "OPEN-R/MW/CONF/CONNECT.CFG": TEMPLATE,
    "OPEN-R/MW/CONF/DESIGNDB.CFG": TEMPLATE,
}


def write(file, text, is_program=False):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(text.encode())
    if is_program:
        file.chmod(0o755)


def make_base(folder):
    for name, text in BASE_FILES.items():
        write(folder / name, text)
    os.chmod(folder / "OPEN-R/MW/CONF/OBJECT.CFG", 0o444)  # as on a CD


class Kit:
    """A folder with a fake SDK, and the program under test."""

    def __init__(self, folder, build):
        self.folder = folder
        self.program = build / "bin/openr"
        self.sdk = folder / "SDK"
        self.log = folder / "mkbin.log"
        write(self.sdk / "bin/mipsel-linux-g++", GXX.format(ccache=CCACHE, tool="g++", standard="-std=gnu++98"), True)
        write(self.sdk / "bin/mipsel-linux-gcc", GXX.format(ccache=CCACHE, tool="gcc", standard="-std=gnu89"), True)
        write(self.sdk / "OPEN_R/bin/mkbin", MKBIN, True)
        write(self.sdk / "OPEN_R/bin/stubgen2", f'#!/bin/sh\nexec {build}/bin/stubgen2 "$@"\n', True)
        shutil.copytree(ROOT / "runtime/include", self.sdk / "OPEN_R/include")
        for flavour in ("BASIC", "WCONSOLE"):
            make_base(self.sdk / f"OPEN_R/MS_ERS200/{flavour}/memprot")

    def run(self, *arguments, sdk=None):
        environment = dict(os.environ, OPENRSDK_ROOT=str(self.sdk if sdk is None else sdk),
                           FAKE_LOG=str(self.log))
        done = subprocess.run([self.program, "stick", *arguments], cwd=self.folder, env=environment,
                              capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def left_behind(self):
        return [f.name for f in self.folder.iterdir() if f.name.startswith(".openr-stick")]

    def refuses(self, name, words, *arguments, sdk=None):
        status, said = self.run("robot", "-o", "never", *arguments, sdk=sdk)
        good = status == 1 and words in said and not (self.folder / "never").exists()
        verdict(name, good and not self.left_behind(), f"status {status}: {said} {self.left_behind()}")


def test_refusals(kit):
    kit.refuses("without OPENRSDK_ROOT", "OPENRSDK_ROOT is not set", sdk="")
    kit.refuses("a folder that is not there", "there is no such folder", sdk="/nowhere/sdk")
    empty = kit.folder / "empty"
    empty.mkdir()
    kit.refuses("an SDK without its compiler", "bin/mipsel-linux-g++: no such program", sdk=empty)
    write(kit.folder / "ours/compile-flags.txt", "")
    kit.refuses("our own tree", "which makes images for this machine", sdk=kit.folder / "ours")
    kit.refuses("a flavour the SDK lacks", "the SDK has for MS_ERS200: BASIC/memprot, WCONSOLE/memprot",
                "--nomemprot")
    kit.refuses("a model the SDK lacks", "the SDK has none at all", "--robot", "ers7")
    kit.refuses("a base without OPEN-R", "there is no OPEN-R/ in it", "--base", str(empty))
    kit.refuses("a controller that is not there", "is no folder", "--controller", "nowhere")
    kit.refuses("a folder without a controller", "no *.c, *.cc or *.cpp", "--controller", str(empty))
    write(kit.folder / "taken/file", "mine")
    status, said = kit.run("robot", "-o", "taken")
    verdict("a folder that is there already", status == 1 and "is there already" in said
            and [f.name for f in (kit.folder / "taken").iterdir()] == ["file"], said)
    status, said = kit.run("robot")
    verdict("no -o is a wrong command line", status == 2 and "--output" in said, said)


def test_stick(kit):
    status, said = kit.run("robot", "-o", "MS/")
    verdict("a stick is made", status == 0 and "POWERMON.BIN" in said, said)
    stick = kit.folder / "MS/OPEN-R"
    if not stick.is_dir():
        return
    verdict("nothing is left behind", not kit.left_behind(), str(kit.left_behind()))
    for name in ("POWERMON", "JOINTMOV", "RCSERVER", "CONTROLL"):
        packed = (stick / f"MW/OBJS/{name}.BIN").read_bytes()
        image = gzip.decompress(packed) if packed[:2] == b"\x1f\x8b" else b""
        verdict(f"{name}.BIN is a gzipped MIPS ELF",
                image[:6] == b"\x7fELF\x01\x01" and image[18:20] == b"\x08\x00", str(packed[:20]))
        verdict(f"{name}.BIN has the stub's table", b"ObjectEntryTable" in image)
        elf = kit.folder / f"MS/elf/{name}.nosnap.elf"
        verdict(f"{name}'s lines are beside the stick", elf.is_file() and b".debug_line" in elf.read_bytes()
                and b".debug_line" not in image, str(elf))
    verdict("and the command says what for", "openr emon EMON.LOG --image MS/elf/NAME.nosnap.elf" in said, said)
    verdict("the controller's main is in", b"controller_main" in
            gzip.decompress((stick / "MW/OBJS/CONTROLL.BIN").read_bytes()))
    log = kit.log.read_text()
    verdict("the network's libraries for RCServer only",
            re.search(r"RCSERVER.*-lInternet -lantMCOOP", log) is not None
            and log.count("-lInternet") == 1, log)
    objects = (stick / "MW/CONF/OBJECT.CFG").read_text()
    verdict("OBJECT.CFG is ours where the base has a template",
            objects == (ROOT / "stub.cfg/OBJECT.CFG").read_text(), objects)
    for name in ("APERIOS.GZ", "SYSTEM/OBJS/VR.BIN", "MW/CONF/DESIGN.CFG", "SYSTEM/CONF/WLANDFLT.TXT"):
        verdict(f"{name} of the base is there", (stick / name).is_file())
    verdict("WLANCONF.TXT is ours", "ETHER_IP=10.0.1.100" in (stick / "SYSTEM/CONF/WLANCONF.TXT").read_text())
    verdict("motions are there", (stick / "MW/DATA/P/SIT.MTN").is_file() or
            any((stick / "MW/DATA/P").glob("*.MTN")), str(list(stick.rglob("*.MTN"))))
    names = [f.name for f in stick.rglob("*")]
    verdict("no files of the build, all names are 8.3",
            all(re.fullmatch(r"[^.]{1,8}(\.[^.]{1,3})?", n) and not n.endswith(".o") for n in names), str(names))
    mode = stat.S_IMODE((stick / "MW/CONF/OBJECT.CFG").stat().st_mode)
    verdict("files can be written to", mode & 0o200 != 0, oct(mode))


def test_base_with_objects(kit):
    base = kit.folder / "base"
    make_base(base)
    os.chmod(base / "OPEN-R/MW/CONF/OBJECT.CFG", 0o644)
    write(base / "OPEN-R/MW/CONF/OBJECT.CFG",
          "/MS/OPEN-R/MW/OBJS/TINYFTPD.BIN\r\n/MS/OPEN-R/MW/OBJS/POWERMON.BIN\r\n[ERS-220]\r\n"
          "/MS/OPEN-R/MW/OBJS/TINYFTPD.BIN\r\n")
    write(base / "OPEN-R/MW/OBJS/TINYFTPD.BIN", "ftp")
    write(base / "OPEN-R/SYSTEM/CONF/WLANCONF.TXT", "ESSID=HOME\n")
    status, said = kit.run("robot", "-o", "merged", "--base", str(base))
    verdict("a base with objects of its own", status == 0, said)
    if status != 0:
        return
    records = [line for line in (kit.folder / "merged/OPEN-R/MW/CONF/OBJECT.CFG").read_text().splitlines()
               if line and not line.startswith("#")]
    at = "/MS/OPEN-R/MW/OBJS/"
    verdict("its objects and ours, each once, before the part of a robot", records ==
            [at + "TINYFTPD.BIN", at + "POWERMON.BIN", at + "JOINTMOV.BIN", at + "RCSERVER.BIN",
             at + "CONTROLL.BIN", "[ERS-220]", at + "TINYFTPD.BIN"], str(records))
    verdict("the network settings of the base stay",
            (kit.folder / "merged/OPEN-R/SYSTEM/CONF/WLANCONF.TXT").read_text() == "ESSID=HOME\n")
    (base / "OPEN-R/MW/OBJS/TINYFTPD.BIN").unlink()
    kit.refuses("an object that is listed and not there",
                "OPEN-R/MW/CONF/OBJECT.CFG:1: '/MS/OPEN-R/MW/OBJS/TINYFTPD.BIN' is not on the stick",
                "--base", str(base))


def symbols(kit, image):
    """Letter and name of each symbol of an image."""
    file = kit.folder / "image.elf"
    file.write_bytes(image)
    listed = subprocess.run(["mipsel-linux-gnu-nm", file], capture_output=True, text=True, check=True).stdout
    return [line.split()[-2:] for line in listed.splitlines()]


def calls_of_main(kit, image):
    """Returns the symbols that are called for main().  Returns all symbols if the image does not call main() or a
    weak symbol is undefined."""
    named = symbols(kit, image)
    if any(letter in "wv" for letter, _ in named) or ["T", "_Z18CallControllerMainv"] not in named:
        return named
    return [name for letter, name in named if letter == "T" and "controller_main" in name]


def test_forms_of_main(kit):
    """Each way to write main() in C++ is called; what cannot be called is refused."""
    folder = kit.folder / "forms"
    for number, (arguments, symbol) in enumerate((("void", "_Z15controller_mainv"),
                                                  ("int, char**", "_Z15controller_mainiPPc"),
                                                  ("int, const char**", "_Z15controller_mainiPPKc"))):
        write(folder / "main.cc", f"int main({arguments}) {{ return 0; }}\n")
        status, said = kit.run("robot", "-o", f"forms{number}", "--controller", "forms")
        verdict(f"main({arguments}) in C++", status == 0, said)
        if status == 0:
            packed = (kit.folder / f"forms{number}/OPEN-R/MW/OBJS/CONTROLL.BIN").read_bytes()
            called = calls_of_main(kit, gzip.decompress(packed))
            verdict(f"main({arguments}) is called", called == [symbol], str(called))
    write(folder / "main.cc", "int helper() { return 0; }\n")
    kit.refuses("a controller without main()", "forms: no source has a main()", "--controller", "forms")
    write(folder / "main.cc", "int main(char*) { return 0; }\n")
    kit.refuses("a main() that nobody can call", "main() has arguments, and the robot gives none", "--controller", "forms")


def test_controller(kit):
    folder = kit.folder / "wave"
    write(folder / "Makefile.sources", "CSRC = wave.c help/more.cc\n")
    write(folder / "wave.c", "#include <device/robot.h>\n#include \"help/more.h\"\n"
                             "static int run(int k) { (void)k; return more(); }\n"
                             "int main(void) { robot_run(run); return 0; }\n")
    write(folder / "help/more.h", "#ifdef __cplusplus\nextern \"C\"\n#endif\nint more(void);\n")
    write(folder / "help/more.cc", "#include \"more.h\"\nint more() { return 64; }\n")
    write(folder / "WLANCONF.TXT", "ESSID=LAB\n")
    write(folder / "nod.mtn", "motion")
    status, said = kit.run("robot", "-o", "waving", "--controller", "wave")
    verdict("a controller of C and C++", status == 0, said)
    if status == 0:
        stick = kit.folder / "waving/OPEN-R"
        image = gzip.decompress((stick / "MW/OBJS/CONTROLL.BIN").read_bytes())
        verdict("is in CONTROLL.BIN", b"more" in image and b"controller_main" in image)
        verdict("and is called", calls_of_main(kit, image) == ["controller_main"], str(calls_of_main(kit, image)))
        verdict("brings its network settings",
                (stick / "SYSTEM/CONF/WLANCONF.TXT").read_text() == "ESSID=LAB\n")
        verdict("and its motions, in upper case", (stick / "MW/DATA/P/NOD.MTN").is_file())
    write(folder / "WLANCONF.TXT", "ESSID = LAB\n")
    kit.refuses("a blank that hangs the boot", "WLANCONF.TXT:1: a blank beside '='", "--controller", "wave")
    (folder / "WLANCONF.TXT").unlink()
    write(folder / "muchtoolong.mtn", "motion")
    kit.refuses("a name that is too long", "'MUCHTOOLONG.MTN' has 11 characters before the dot",
                "--controller", "wave")
    (folder / "muchtoolong.mtn").unlink()
    write(folder / "wave.c", "int main(void) { return undeclared; }\n")
    kit.refuses("a controller that does not compile", "wave.c: ", "--controller", "wave")
    write(folder / "Makefile.sources", "CSRC = gone.c\n")
    kit.refuses("a source that is not there", "there is no file 'gone.c'", "--controller", "wave")


def test_wrong_tools(kit):
    write(kit.sdk / "OPEN_R/bin/mkbin", "#!/bin/sh\nexit 3\n", True)
    kit.refuses("an mkbin that fails", "POWERMON.BIN: ", )
    write(kit.sdk / "OPEN_R/bin/mkbin", '#!/bin/sh\nwhile [ "$1" != -o ]; do shift; done\ncp /bin/true "$2"\n', True)
    kit.refuses("an image for this machine", "is for another processor")


def test_host(kit):
    status, said = kit.run("host", "-o", "copy")
    stick = kit.folder / "copy/OPEN-R/MW"
    verdict("a stick for the host", status == 0 and (stick / "OBJS/JOINTMOV.BIN").is_file()
            and not list(stick.rglob("*.DBG")), said)
    status, said = kit.run("host", "-o", "copy")
    verdict("not over another one", status == 1 and "is there already" in said, said)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=Path)
    build = parser.parse_args().build.resolve()
    with tempfile.TemporaryDirectory(prefix="openr-stick-test-") as folder:
        kit = Kit(Path(folder), build)
        test_refusals(kit)
        test_stick(kit)
        test_base_with_objects(kit)
        test_controller(kit)
        test_forms_of_main(kit)
        test_host(kit)
        test_wrong_tools(kit)
    return finish()


if __name__ == "__main__":
    sys.exit(main())
