#!/usr/bin/env python3
"""tools/sdk_surface.py: what it finds in objects that use more than the robot has, and that it is
silent otherwise.  The last line is "N passed, N failed"."""
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
TOOL = ROOT / "tools/sdk_surface.py"
sys.path.insert(0, str(TOOL.parent))
import sdk_surface  # noqa: E402
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from verdicts import finish, verdict  # noqa: E402

GOOD = """
#include <OPENR/OObject.h>
#include <stdio.h>
#include <string>
#include "def.h"
// fork() and std::thread in a comment, "fork()" in a string: nobody's business.
class Dog : public OObject {
public:
    OSubject* subject[numOfSubject];
    virtual OStatus DoInit(const OSystemEvent& event);
    void Walk(int steps, const char* why);
private:
    enum State { IDLE, WALKING } state_;
    std::string name_;
    antStackRef ipstack_;
    int (*callback_)(int);
};
OStatus Dog::DoInit(const OSystemEvent& event)
{
    OSYSLOG1((osyslogERROR, "fork() %d", (int)state_));
    int a = 0, *b = &a;
    TCPEndpointListenMsg listen(*b);
    listen.Call(ipstack_, sizeof(listen));
    name_.push_back('x');
    return OPENR::OpenPrimitive(name_.c_str(), 0) == oSUCCESS ? oSUCCESS : oFAIL;
}
"""

# Text for the place of "//HERE" in a good source, and the complaint about it, which names line 6.
PLANTED = [
    ("std::thread t(Walk);", "std::thread: not in the robot's C++ library of 1998"),
    ("if (fork() == 0) return;", "fork(): not there, or without effect, on the robot"),
    ("::fork();", "fork(): not there, or without effect, on the robot"),
    ("int now = time(0);", "time(): not there, or without effect, on the robot"),
    ("usleep(1000);", "usleep(): not there, or without effect, on the robot"),
    ("pthread_t t = 0; return fork();", "fork(): not there, or without effect, on the robot"),
    ("int n = getppid();", "getppid: not declared here, and not of the SDK or the robot's C library"),
    ("std::unordered_map<int, int> m;", "std::unordered_map: not in the robot's C++ library of 1998"),
    ("openr_host::System* s = 0;", "System: not declared here"),
    ("longword w = ocamparamWB_FL_MODE;", "ocamparamWB_FL_MODE: only our OPENR/OPrimitiveControl.h has it"),
    ("uint32_t n = 0;", "uint32_t: not declared here"),
    ("OPENR::Teleport();", "Teleport: not declared here"),
    ("a.fallocate(3);", "fallocate: not declared here"),
]
# Macros of the robot's headers: not even a program's own may have these names.
MACROS = [
    ("static const int HEADER_SIZE = 256;", "HEADER_SIZE"),
    ("enum State { IDLE, ERROR };", "ERROR"),
    ("int max = 0;", "max"),
    ("void Stop(int TIMEOUT);", "TIMEOUT"),
    ("struct Reply { int OK; };", "OK"),
    ("#define MIN(a, b) ((a) < (b) ? (a) : (b))", "MIN"),
]
INCLUDES = [
    ('#include "runtime/core/system.h"', '"runtime/core/system.h": neither the SDK nor'),
    ("#include <sys/socket.h>", "<sys/socket.h>: neither the SDK nor"),
    ("#include <thread>", "<thread>: neither the SDK nor"),
    ("#include <stdint.h>", "<stdint.h>: neither the SDK nor"),
    ("#include <OPENR/formats/sensors.h>", "a header of this project that the SDK does not have"),
]

def check(text):
    """Returns the tool's status for a folder with this source, and its text without the folder's name."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "Dog.cc").write_text(text)
        done = subprocess.run([sys.executable, str(TOOL), folder], capture_output=True, text=True)
        return done.returncode, done.stdout.replace(folder + "/", "") + done.stderr


def check_headers():
    """Our own headers may have the macros themselves and what a reference names, nothing else."""
    text = ("#define HWADDRESS_MAX_LEN 32\nconst int OID_UNDEF = 1;\nconst int HEADER_SIZE = 4;\n"
            "void Set(int min);\n// ERROR\n")
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "Ours.h").write_text(text)
        found = [said.split("/")[-1] for said in sdk_surface.Surface().check_headers(folder)]
    words = "a macro of the robot's headers; take another name"
    verdict("macro names in headers", found == [f"Ours.h:3: HEADER_SIZE: {words}", f"Ours.h:4: min: {words}"],
            found)


def main():
    status, said = check(GOOD)
    verdict("a good object is passed over in silence", (status, said) == (0, ""), said)
    for line, words in PLANTED:
        status, said = check("#include <OPENR/OObject.h>\nint a;\nvoid\nWalk()\n{\n    " + line + "\n}\n")
        verdict(line, status == 1 and said.startswith("Dog.cc:6: ") and words in said, said)
    for line, name in MACROS:
        status, said = check("#include <OPENR/OObject.h>\n\n" + line + "\n")
        verdict(line, status == 1 and f"Dog.cc:3: {name}: a macro of the robot's headers" in said, said)
    check_headers()
    for line, words in INCLUDES:
        status, said = check("\n" + line + "\n")
        verdict(line, status == 1 and said.startswith("Dog.cc:2: ") and words in said, said)
    good_symbols = ("OPENR::OpenPrimitive(char const*, unsigned int*)\nfopen\noperator new(unsigned int)\n"
                    "RCRegion::operator new(unsigned int)\nOObject::~OObject()\nstd::__throw_length_error(char const*)\n")
    for symbols, words in [(good_symbols, ""), ("fork\n", "fork: called"), ("gettimeofday\n", "gettimeofday: called"),
                           ("std::thread::join()\n", "std::thread::join(): called"),
                           ("openr_host::System::now_us() const\n", "openr_host::System::now_us() const: called")]:
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "symbols").write_text(symbols)
            done = subprocess.run([sys.executable, str(TOOL), "--symbols", f"{folder}/symbols"],
                                  capture_output=True, text=True)
            good = done.stdout == "" if words == "" else words in done.stdout and done.returncode == 1
            verdict(f"symbols {symbols}", good, done.stdout + done.stderr)
    listed = subprocess.run([sys.executable, str(TOOL), "--list"], capture_output=True, text=True).stdout
    for name in ("OpenPrimitive", "<OPENR/OObject.h>", "std::vector", "fopen"):
        verdict(f"--list names {name}", f"\n{name}\t" in "\n" + listed, listed[:500])
    return finish()


if __name__ == "__main__":
    sys.exit(main())
