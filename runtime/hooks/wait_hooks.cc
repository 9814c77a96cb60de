// sleep(), poll() and other functions that wait, for objects: they do not wait, because the robot
// has no sleep, and all other objects would wait too.
#include <fmt/format.h>
#include <poll.h>
#include <sys/select.h>
#include <time.h>
#include <unistd.h>

#include "runtime/core/system.h"
#include "runtime/hooks/open_file.h"
#include "runtime/hooks/refuse.h"

using openr_host::ApiScope;
using openr_host::InObject;
using openr_host::NextSymbol;
using openr_host::Refuses;
using openr_host::Severity;
using openr_host::t_current;

namespace {

// Reports that an object has called `function` (sleep() and similar), which does nothing here,
// because the robot has no sleep.
void ReportSleep(const char* function) {
  const ApiScope scope;
  t_current.system->AddFinding(Severity::kWarning,
                               fmt::format("{}() does nothing: the robot has no sleep; wait for "
                                           "an event instead",
                                           function));
}

// Ends a call of `function` by an object.  Without descriptors (`has_descriptors` is false) the
// call is a sleep, which does nothing and returns 0.  A call with descriptors is refused, because
// the robot has no such function.
int EndWait(const char* function, bool has_descriptors) {
  if (has_descriptors) return Refuses(function) ? -1 : 0;
  ReportSleep(function);
  return 0;
}

// Looks up the C library's poll() when the runtime is loaded, because later a signal handler may be
// the first caller of poll().
[[gnu::constructor]] void FindPoll() { poll(nullptr, 0, 0); }

// Does as poll() of an object's `count` descriptors that does not wait: files are always ready. The
// console never is, because whether text waits there may depend on the time of the host.
int PollFiles(struct pollfd* descriptors, nfds_t count) {
  int ready = 0;
  for (nfds_t i = 0; i < count; ++i) {
    struct pollfd& each = descriptors[i];
    each.revents = 0;
    if (each.fd < 0 || openr_host::IsConsole(each.fd)) continue;
    const bool is_refused = openr_host::RefusesDescriptor("poll", each.fd);
    each.revents = static_cast<short>(is_refused ? POLLNVAL : each.events & (POLLIN | POLLOUT));
    if (each.revents != 0) ++ready;
  }
  return ready;
}

}  // namespace

extern "C" {

int usleep(useconds_t us) {
  static const auto next = NextSymbol<int(useconds_t)>("usleep");
  if (!InObject()) return next(us);
  ReportSleep("usleep");
  return 0;
}

unsigned sleep(unsigned seconds) {
  static const auto next = NextSymbol<unsigned(unsigned)>("sleep");
  if (!InObject()) return next(seconds);
  ReportSleep("sleep");
  return 0;
}

int nanosleep(const struct timespec* time, struct timespec* left) {
  static const auto next = NextSymbol<int(const struct timespec*, struct timespec*)>("nanosleep");
  if (!InObject()) return next(time, left);
  ReportSleep("nanosleep");
  return 0;
}

int clock_nanosleep(clockid_t clock, int flags, const struct timespec* time,
                    struct timespec* left) {
  static const auto next = OPENR_NEXT(clock_nanosleep);
  if (!InObject()) return next(clock, flags, time, left);
  ReportSleep("clock_nanosleep");
  return 0;
}

int poll(struct pollfd* descriptors, nfds_t count, int timeout_ms) {
  static const auto next = OPENR_NEXT(poll);
  if (!InObject()) return next(descriptors, count, timeout_ms);
  // Answers a poll() that does not wait, because std::ifstream calls poll() in this way for
  // in_avail().
  if (count > 0 && timeout_ms == 0) return PollFiles(descriptors, count);
  return EndWait("poll", count > 0);
}

int ppoll(struct pollfd* descriptors, nfds_t count, const struct timespec* timeout,
          const sigset_t* signals) {
  static const auto next = OPENR_NEXT(ppoll);
  if (!InObject()) return next(descriptors, count, timeout, signals);
  return EndWait("ppoll", count > 0);
}

int select(int count, fd_set* reads, fd_set* writes, fd_set* errors, struct timeval* timeout) {
  static const auto next = OPENR_NEXT(select);
  if (!InObject()) return next(count, reads, writes, errors, timeout);
  return EndWait("select", count > 0 && (reads != nullptr || writes != nullptr));
}

int pselect(int count, fd_set* reads, fd_set* writes, fd_set* errors,
            const struct timespec* timeout, const sigset_t* signals) {
  static const auto next = OPENR_NEXT(pselect);
  if (!InObject()) return next(count, reads, writes, errors, timeout, signals);
  return EndWait("pselect", count > 0 && (reads != nullptr || writes != nullptr));
}

}  // extern "C"
