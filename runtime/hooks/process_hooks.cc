// exit(), abort(), lists of functions for the end, clocks and rand() for objects.  These functions
// differ from those of the C library only while code of an image (a program of the robot) runs.
//
// exit() and abort() end the handler that runs, not the process (Programmer's Guide, appendix A).
// So the robot never runs destructors of global objects, nor functions given to atexit().
// The only working clock of the robot is GetSystemTime().  A program that reads another clock gets
// virtual time, so that every run is the same.
#include <fmt/format.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/times.h>
#include <time.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "runtime/core/robot_fault.h"
#include "runtime/core/system.h"
#include "runtime/hooks/hook.h"

using openr_host::ApiScope;
using openr_host::InObject;
using openr_host::NextSymbol;
using openr_host::Severity;
using openr_host::StopAsTheRobotDoes;
using openr_host::t_current;

namespace {

bool InHandler() { return InObject() && t_current.object->running() != nullptr; }

// Returns whether a constructor of an object's global variables runs.
bool InConstructors() { return InObject() && t_current.object->running() == nullptr; }

// Ends the run because a constructor of an object's global variables has called `function`.  Such a
// call normally ends the running handler, but here no handler runs, and the object cannot run
// without its global variables.
[[noreturn]] void RefuseInConstructors(const char* function) {
  std::string why;
  {
    const ApiScope scope;
    why = fmt::format("a constructor of a global object has called {}()", function);
  }
  StopAsTheRobotDoes(why);
}

// The beginning of the robot's calendar, 2000, in seconds since 1970.
constexpr int64_t kRobotEpochS = 946'684'800;

int64_t VirtualUs() { return t_current.system->now_us(); }

[[noreturn]] void EndMethod() {
  t_current.image_code = false;
  t_current.system->AbandonHandler();
}

// If code of an object has called `function`, ends the running handler, as exit() does, or the run
// if a constructor of a global object is the caller.  Returns for other callers.
void EndForObject(const char* function) {
  if (InHandler()) EndMethod();
  if (InConstructors()) RefuseInConstructors(function);
}

// Ends the process at once, as _exit() of the C library does.  Makes the system call itself,
// because signal handlers of this program call _exit() and must not look the C library's function
// up.
[[noreturn]] void EndProcess(int status) {
  for (;;) syscall(SYS_exit_group, status);
}

}  // namespace

extern "C" {

void exit(int status) noexcept {
  EndForObject("exit");
  static const auto next = NextSymbol<void(int)>("exit");
  next(status);
  __builtin_unreachable();
}

void quick_exit(int status) noexcept {
  EndForObject("quick_exit");
  static const auto next = NextSymbol<void(int)>("quick_exit");
  next(status);
  __builtin_unreachable();
}

void _exit(int status) {
  EndForObject("_exit");
  EndProcess(status);
}

void _Exit(int status) noexcept {
  EndForObject("_Exit");
  EndProcess(status);
}

void pthread_exit(void* result) {
  if (InHandler()) {
    {
      const ApiScope scope;
      t_current.system->AddFinding(Severity::kError,
                                   "pthread_exit() called: the robot has no threads; the method "
                                   "ends, as by exit()");
    }
    EndMethod();
  }
  if (InConstructors()) RefuseInConstructors("pthread_exit");
  static const auto next = NextSymbol<void(void*)>("pthread_exit");
  next(result);
  __builtin_unreachable();
}

void abort() noexcept {
  if (InHandler()) {
    {
      const ApiScope scope;
      t_current.system->Print("abort() called\n");
      t_current.system->AddFinding(Severity::kError,
                                   "abort() called: the method ends, the object goes on "
                                   "in whatever state it is");
    }
    EndMethod();
  }
  if (InConstructors()) RefuseInConstructors("abort");
  static const auto next = NextSymbol<void()>("abort");
  next();
  __builtin_unreachable();
}

// Ends the running handler of an object.  assert() calls this function when its condition does not
// hold.
void __assert_fail(const char* condition, const char* file, unsigned line,
                   const char* function) noexcept {
  static const auto next =
      NextSymbol<void(const char*, const char*, unsigned, const char*)>("__assert_fail");
  if (InObject()) {
    {
      const ApiScope scope;
      t_current.system->Print(
          fmt::format("assertion \"{}\" failed: file \"{}\", line {}\n", condition, file, line));
    }
    abort();
  }
  next(condition, file, line, function);
  __builtin_unreachable();
}

// Registers the destructor of a static C++ variable, or a function given to atexit().  Registers
// nothing for objects, because nothing on the robot calls these functions.  Here dlclose() would
// call them outside of all hooks and after the report of the run.
int __cxa_atexit(void (*function)(void*), void* argument, void* module) noexcept {
  static const auto next = NextSymbol<int(void (*)(void*), void*, void*)>("__cxa_atexit");
  return InObject() ? 0 : next(function, argument, module);
}

// Registers the destructor of a thread_local C++ variable; nothing for objects, as __cxa_atexit().
int __cxa_thread_atexit_impl(void (*function)(void*), void* argument, void* module) noexcept {
  static const auto next =
      NextSymbol<int(void (*)(void*), void*, void*)>("__cxa_thread_atexit_impl");
  return InObject() ? 0 : next(function, argument, module);
}

int on_exit(void (*function)(int, void*), void* argument) noexcept {
  static const auto next = NextSymbol<int(void (*)(int, void*), void*)>("on_exit");
  return InObject() ? 0 : next(function, argument);
}

time_t time(time_t* result) noexcept {
  static const auto next = NextSymbol<time_t(time_t*)>("time");
  if (!InObject()) return next(result);
  const time_t now = kRobotEpochS + VirtualUs() / 1'000'000;
  if (result != nullptr) *result = now;
  return now;
}

int gettimeofday(struct timeval* tv, void* zone) noexcept {
  static const auto next = NextSymbol<int(struct timeval*, void*)>("gettimeofday");
  if (!InObject()) return next(tv, zone);
  tv->tv_sec = kRobotEpochS + VirtualUs() / 1'000'000;
  tv->tv_usec = VirtualUs() % 1'000'000;
  return 0;
}

int clock_gettime(clockid_t id, struct timespec* ts) noexcept {
  static const auto next = NextSymbol<int(clockid_t, struct timespec*)>("clock_gettime");
  if (!InObject()) return next(id, ts);
  ts->tv_sec = (id == CLOCK_REALTIME ? kRobotEpochS : 0) + VirtualUs() / 1'000'000;
  ts->tv_nsec = VirtualUs() % 1'000'000 * 1000;
  return 0;
}

int timespec_get(struct timespec* ts, int base) noexcept {
  static const auto next = NextSymbol<int(struct timespec*, int)>("timespec_get");
  if (!InObject()) return next(ts, base);
  if (base != TIME_UTC) return 0;
  clock_gettime(CLOCK_REALTIME, ts);
  return base;
}

// Returns virtual time in ticks of 10 ms, those of sysconf(_SC_CLK_TCK).  The processor's time is
// virtual time as well, as in clock().
clock_t times(struct tms* parts) noexcept {
  static const auto next = NextSymbol<clock_t(struct tms*)>("times");
  if (!InObject()) return next(parts);
  constexpr int64_t kTickUs = 10'000;
  const clock_t ticks = VirtualUs() / kTickUs;
  if (parts != nullptr) *parts = {ticks, 0, 0, 0};
  return ticks;
}

clock_t clock() noexcept {
  static const auto next = NextSymbol<clock_t()>("clock");
  return InObject() ? static_cast<clock_t>(VirtualUs()) : next();
}

int rand() noexcept {
  static const auto next = NextSymbol<int()>("rand");
  return InObject() ? t_current.object->NextRandom() : next();
}

void srand(unsigned seed) noexcept {
  static const auto next = NextSymbol<void(unsigned)>("srand");
  if (InObject()) {
    t_current.object->SeedRandom(seed);
  } else {
    next(seed);
  }
}

long random() noexcept {
  static const auto next = NextSymbol<long()>("random");
  return InObject() ? t_current.object->NextRandom() : next();
}

void srandom(unsigned seed) noexcept {
  static const auto next = NextSymbol<void(unsigned)>("srandom");
  if (InObject()) {
    t_current.object->SeedRandom(seed);
  } else {
    next(seed);
  }
}

// Returns the next number of std::random_device: the function std::random_device::_M_getval() of
// the C++ library, which would read a random number of the processor.  The robot has no such
// device, so an object gets numbers of its rand().
unsigned openr_random_device_value(void* device) asm("_ZNSt13random_device9_M_getvalEv");

unsigned openr_random_device_value(void* device) {
  static const auto next = NextSymbol<unsigned(void*)>("_ZNSt13random_device9_M_getvalEv");
  if (!InObject()) return next(device);
  // NextRandom() returns 31 bits, so the highest bit comes from a second number.
  openr_host::Object* const object = t_current.object;
  const auto low = static_cast<unsigned>(object->NextRandom());
  return low | static_cast<unsigned>(object->NextRandom()) << 31;
}

}  // extern "C"
