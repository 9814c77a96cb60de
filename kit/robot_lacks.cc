#include "kit/robot_lacks.h"

#include <algorithm>
#include <initializer_list>

namespace openr_host {
namespace {

// A group of functions that the robot lacks for the same reason.  The groups are taken from the
// Programmer's Guide, appendix A (parts of the C library that do not work), and from
// docs/openr/core.md, sections 6.1 and 6.4 (threads and sleeping).
struct Group {
  std::initializer_list<std::string_view> names;
  LackedCall call;
};

const Group kGroups[] = {
    {{"system", "popen", "fork", "vfork", "execl", "execlp", "execv", "execve", "execvp", "wait",
      "waitpid", "kill", "getpid"},
     {true,
      "the robot has no processes: all it runs are the objects of its stick. What another program "
      "does belongs into this one, or into an object of its own"}},
    {{"signal", "sigaction", "raise", "alarm", "setitimer"},
     {true,
      "the robot has no signals. What is to happen at shutdown is the function of robot_die(); "
      "what is to happen later, the run function does at a later call"}},
    {{"pthread_create", "thrd_create", "std::thread", "std::async", "CreateThread", "_beginthread"},
     {true,
      "the robot has no threads: an object is one, and does one thing at a time. Do a piece of "
      "the work at every call of the run function"}},
    {{"socket", "socketpair", "gethostbyname", "getaddrinfo", "inet_addr", "select", "poll"},
     {true,
      "the robot has no sockets: its network is reached by messages to the IPStack, which an "
      "object sends and a controller cannot. RCServer is the way in from outside "
      "(docs/remote-control.md)"}},
    {{"sleep", "usleep", "nanosleep", "Sleep"},
     {false,
      "the robot has no sleep, and here it does nothing: time passes between the calls of the run "
      "function only. Let the run function return how long to wait, in ms"}},
    {{"time", "clock", "gettimeofday", "clock_gettime", "ftime"},
     {false,
      "the robot has no such clock (here it is virtual time). Add up the ms that the run "
      "function returns"}},
    {{"tmpfile", "tmpnam", "tempnam", "mktemp", "mkstemp", "chdir", "getcwd", "dup", "dup2", "pipe",
      "fcntl", "fdopen", "link", "symlink", "truncate", "chmod", "mmap"},
     {true,
      "the robot has no such file call: there are open, fopen and their like, stat, rename, "
      "remove, mkdir, rmdir and opendir, on files of the Memory Stick"}},
};

}  // namespace

const LackedCall* FindLackedCall(std::string_view name) {
  for (const Group& group : kGroups) {
    if (std::find(group.names.begin(), group.names.end(), name) != group.names.end())
      return &group.call;
  }
  return nullptr;
}

bool TakesFileName(std::string_view name) {
  constexpr std::string_view kNames[] = {"fopen",  "freopen", "open",  "opendir", "remove",
                                         "unlink", "rename",  "mkdir", "rmdir",   "stat"};
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

}  // namespace openr_host
