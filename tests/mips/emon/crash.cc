// Crashes in a method of a class, and prints the registers and the stack at that moment, one
// "name value" a line.  emon_test.py makes a crash record of a robot of them.
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <ucontext.h>
#include <unistd.h>

#define APART __attribute__((noinline, noclone))

class Dancer {
 public:
  Dancer() : steps(0) {}
  APART int Notify(const int* data) { return Step(data) + steps; }

 private:
  APART int Step(const int* data) {
    ++steps;
    return *data + 1;  // crashes here
  }

  volatile int steps;
};

static void Print(int, siginfo_t* info, void* context) {
  const mcontext_t& machine = static_cast<const ucontext_t*>(context)->uc_mcontext;
  const uint32_t sp = static_cast<uint32_t>(machine.gregs[29]);
  printf("epc %08x\n", static_cast<unsigned>(machine.pc));
  printf("badvaddr %08x\n", static_cast<unsigned>(reinterpret_cast<uintptr_t>(info->si_addr)));
  for (int i = 0; i < 32; ++i) printf("r%d %08x\n", i, static_cast<unsigned>(machine.gregs[i]));
  for (uint32_t at = sp; at < sp + 256; at += 4)
    printf("stack %08x %08x\n", at, *reinterpret_cast<uint32_t*>(at));
  fflush(stdout);
  _exit(0);
}

int main(int argc, char**) {
  struct sigaction action = {};
  action.sa_sigaction = &Print;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSEGV, &action, 0);
  const int* const data = argc > 5 ? &argc : 0;
  Dancer dancer;
  return dancer.Notify(data) == 0;
}
