// Functions of the C library that do not exist on the robot (Programmer's Guide, appendix A).  If
// an object calls such a function, the call fails and adds a finding.  So objects cannot reach
// files and processes of the host.
#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>

#include "runtime/core/system.h"
#include "runtime/hooks/refuse.h"

namespace openr_host {

bool Refuses(const char* name, const char* why) {
  if (!InObject()) return false;
  const ApiScope scope;
  t_current.system->AddFinding(Severity::kError, fmt::format("{}() fails: {}", name, why));
  errno = ENOSYS;
  return true;
}

}  // namespace openr_host

using openr_host::Refuses;

namespace {

// The arguments of execl(), execlp() or execle() as the array that execv() takes.  The array has a
// fixed size, because a process that was forked from one with threads must not allocate memory.
class ArgumentArray {
 public:
  // Takes `first` and the arguments that follow in `*rest`, up to a null pointer.
  ArgumentArray(const char* first, va_list* rest) {
    for (const char* next = first; next != nullptr; next = va_arg(*rest, const char*)) {
      if (size_ + 1 < all_.size()) all_[size_] = const_cast<char*>(next);
      ++size_;
    }
  }
  // Returns the array, or null, with errno set, if there were too many arguments.
  char* const* Get() const {
    if (size_ < all_.size()) return all_.data();
    errno = E2BIG;
    return nullptr;
  }

 private:
  std::array<char*, 1024> all_{};  // ends with a null pointer
  size_t size_ = 0;
};

}  // namespace

OPENR_REFUSE(int, system, -1, (const char* command), (command))
OPENR_REFUSE(FILE*, popen, nullptr, (const char* command, const char* mode), (command, mode))
OPENR_REFUSE(pid_t, fork, -1, () noexcept, ())
OPENR_REFUSE(int, execve, -1,
             (const char* path, char* const* arguments, char* const* environment) noexcept,
             (path, arguments, environment))
OPENR_REFUSE(int, execv, -1, (const char* path, char* const* arguments) noexcept, (path, arguments))
OPENR_REFUSE(int, execvp, -1, (const char* file, char* const* arguments) noexcept,
             (file, arguments))
OPENR_REFUSE(int, execvpe, -1,
             (const char* file, char* const* arguments, char* const* environment) noexcept,
             (file, arguments, environment))
OPENR_REFUSE(int, posix_spawn, ENOSYS,
             (pid_t * process, const char* path, const posix_spawn_file_actions_t* actions,
              const posix_spawnattr_t* attributes, char* const* arguments,
              char* const* environment),
             (process, path, actions, attributes, arguments, environment))
OPENR_REFUSE(int, posix_spawnp, ENOSYS,
             (pid_t * process, const char* file, const posix_spawn_file_actions_t* actions,
              const posix_spawnattr_t* attributes, char* const* arguments,
              char* const* environment),
             (process, file, actions, attributes, arguments, environment))
OPENR_REFUSE(pid_t, getpid, -1, () noexcept, ())
OPENR_REFUSE(int, kill, -1, (pid_t process, int number) noexcept, (process, number))
OPENR_REFUSE(int, raise, -1, (int number) noexcept, (number))
OPENR_REFUSE(sighandler_t, signal, SIG_ERR, (int number, sighandler_t handler) noexcept,
             (number, handler))
OPENR_REFUSE(int, sigaction, -1,
             (int number, const struct sigaction* wanted, struct sigaction* former) noexcept,
             (number, wanted, former))
OPENR_REFUSE(int, sigprocmask, -1, (int how, const sigset_t* wanted, sigset_t* former) noexcept,
             (how, wanted, former))
OPENR_REFUSE(int, pthread_sigmask, ENOSYS,
             (int how, const sigset_t* wanted, sigset_t* former) noexcept, (how, wanted, former))
OPENR_REFUSE(unsigned, alarm, 0, (unsigned seconds) noexcept, (seconds))
OPENR_REFUSE(int, setitimer, -1,
             (__itimer_which_t which, const struct itimerval* wanted,
              struct itimerval* former) noexcept,
             (which, wanted, former))
OPENR_REFUSE(int, timer_create, -1,
             (clockid_t clock, struct sigevent* event, timer_t* timer) noexcept,
             (clock, event, timer))
OPENR_REFUSE(pid_t, wait, -1, (int* status), (status))
OPENR_REFUSE(pid_t, waitpid, -1, (pid_t process, int* status, int options),
             (process, status, options))
OPENR_REFUSE(int, waitid, -1, (idtype_t kind, id_t id, siginfo_t* info, int options),
             (kind, id, info, options))
OPENR_REFUSE(pid_t, wait3, -1, (int* status, int options, struct rusage* usage) noexcept,
             (status, options, usage))
OPENR_REFUSE(pid_t, wait4, -1,
             (pid_t process, int* status, int options, struct rusage* usage) noexcept,
             (process, status, options, usage))
OPENR_REFUSE(int, killpg, -1, (pid_t group, int number) noexcept, (group, number))
OPENR_REFUSE(int, sigqueue, -1, (pid_t process, int number, const union sigval value) noexcept,
             (process, number, value))
OPENR_REFUSE(int, pthread_kill, ENOSYS, (pthread_t thread, int number) noexcept, (thread, number))
OPENR_REFUSE(useconds_t, ualarm, 0, (useconds_t first, useconds_t interval) noexcept,
             (first, interval))
OPENR_REFUSE(int, pause, -1, (), ())
OPENR_REFUSE(int, sigsuspend, -1, (const sigset_t* mask), (mask))
OPENR_REFUSE(int, sigwait, ENOSYS, (const sigset_t* signals, int* number), (signals, number))
OPENR_REFUSE(FILE*, tmpfile, nullptr, (), ())
OPENR_REFUSE(char*, tmpnam, nullptr, (char* name) noexcept, (name))
OPENR_REFUSE(char*, tempnam, nullptr, (const char* folder, const char* prefix) noexcept,
             (folder, prefix))
OPENR_REFUSE(char*, mktemp, nullptr, (char* name) noexcept, (name))
OPENR_REFUSE(int, mkstemp, -1, (char* name), (name))
OPENR_REFUSE(FILE*, fdopen, nullptr, (int descriptor, const char* mode) noexcept,
             (descriptor, mode))
OPENR_REFUSE(int, link, -1, (const char* from, const char* to) noexcept, (from, to))
OPENR_REFUSE(int, symlink, -1, (const char* from, const char* to) noexcept, (from, to))
OPENR_REFUSE(int, chdir, -1, (const char* path) noexcept, (path))
OPENR_REFUSE(char*, getcwd, nullptr, (char* path, size_t size) noexcept, (path, size))
OPENR_REFUSE(int, truncate, -1, (const char* path, off_t size) noexcept, (path, size))
OPENR_REFUSE(int, chmod, -1, (const char* path, mode_t mode) noexcept, (path, mode))
OPENR_REFUSE(int, dup, -1, (int descriptor) noexcept, (descriptor))
OPENR_REFUSE(int, dup2, -1, (int from, int to) noexcept, (from, to))
OPENR_REFUSE(int, dup3, -1, (int from, int to, int flags) noexcept, (from, to, flags))
// pipe() and pipe2() are not refused in a build with a sanitizer, because the sanitizer itself
// calls pipe() to test whether memory is readable, and may call pipe2().
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
OPENR_REFUSE(int, pipe, -1, (int* ends) noexcept, (ends))
OPENR_REFUSE(int, pipe2, -1, (int* ends, int flags) noexcept, (ends, flags))
#endif
OPENR_REFUSE(int, socket, -1, (int domain, int type, int protocol) noexcept,
             (domain, type, protocol))
OPENR_REFUSE(int, socketpair, -1, (int domain, int type, int protocol, int* ends) noexcept,
             (domain, type, protocol, ends))
OPENR_REFUSE(int, pthread_cancel, ENOSYS, (pthread_t thread), (thread))

// Refuses vfork to objects.  Makes a fork for other callers: the memory of a process that vfork
// makes is that of its caller, so this function could not return in it.
OPENR_REFUSE_FOR(pid_t, vfork, fork, -1, () noexcept, ())

extern "C" int execl(const char* path, const char* first, ...) noexcept {
  if (Refuses("execl")) return -1;
  va_list rest;
  va_start(rest, first);
  const ArgumentArray arguments(first, &rest);
  va_end(rest);
  return arguments.Get() == nullptr ? -1 : execv(path, arguments.Get());
}

extern "C" int execlp(const char* file, const char* first, ...) noexcept {
  if (Refuses("execlp")) return -1;
  va_list rest;
  va_start(rest, first);
  const ArgumentArray arguments(first, &rest);
  va_end(rest);
  return arguments.Get() == nullptr ? -1 : execvp(file, arguments.Get());
}

extern "C" int execle(const char* path, const char* first, ...) noexcept {
  if (Refuses("execle")) return -1;
  va_list rest;
  va_start(rest, first);
  const ArgumentArray arguments(first, &rest);
  char* const* const environment = va_arg(rest, char* const*);
  va_end(rest);
  return arguments.Get() == nullptr ? -1 : execve(path, arguments.Get(), environment);
}

// Refuses fcntl() to objects.  For other callers, passes the third argument on as a pointer.  This
// is right even if the argument is an int, because the calling convention passes an int and a
// pointer in the same way.
extern "C" int fcntl(int descriptor, int command, ...) {
  static const auto next = OPENR_NEXT(fcntl);
  va_list arguments;
  va_start(arguments, command);
  void* const argument = va_arg(arguments, void*);
  va_end(arguments);
  return Refuses("fcntl") ? -1 : next(descriptor, command, argument);
}

// pthread_create() is not refused in a build with ThreadSanitizer, because ThreadSanitizer starts a
// thread before this library is ready.
#if !defined(__SANITIZE_THREAD__)
// Refuses to start a thread for an object, also with std::thread, which calls this function.  A
// thread would run at the same time as the handlers, so the order of their steps would differ from
// run to run.
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*start)(void*), void* argument) noexcept {
  static const auto next = OPENR_NEXT(pthread_create);
  constexpr char kReason[] =
      "the robot has no threads: an object does one thing at a time; do a piece of the work for "
      "each message";
  return Refuses("pthread_create", kReason) ? EAGAIN : next(thread, attributes, start, argument);
}
#endif
