// Makes copies of this process with fork(); a copy runs the same program as the original.  All
// copies that the product makes are made by CopyProcess(), so that the following holds for each of
// them.
//
// - Memory and threads: the copy has all memory of the original, with its fibers and objects, but
//   only the thread that makes it.  So the original must have one thread, unless the copy calls
//   only functions that are allowed after fork() in a process with several threads.
// - Descriptors: the copy has all descriptors of the original, also those with O_CLOEXEC.  The copy
//   must close the ends of pipes and sockets by which other processes see that the original has
//   ended.
// - Streams: text in the buffer of a stream would be written by both processes.  The argument
//   `flushed` says which streams the original writes out before it makes the copy.
// - Signals: handlers, and signals that are ignored or blocked, are as in the original.
// - End of the original: the argument `orphan` says what happens to the copy.
// - End of the copy: the copy ends by EndCopy(), or by _exit() if its buffered text is to be
//   dropped.  It does not call exit(), because only the original must run exit handlers.  Two
//   kinds of copies go on as whole programs, and leave main(): those of openr join --restart, and
//   the branch with which a run goes on from its past (Rewind).
// - Exit status: the original waits for the end of the copy (WaitForEnd() or WaitForAllCopies()),
//   because the copy stays as a zombie until then.
//
// To start another program, use ProgramStart (runtime/base/program_start.h).
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <functional>
#include <string>

namespace openr_host {

// The streams whose buffered text is written out before a copy is made.
enum class Flushed {
  kNone,  // no stream: the buffers are empty, or the copy ends without writing them
  kOwn,   // only stdout and stderr: writing out the files of objects changes what objects read
  kAll,   // all streams of the C library, also the files of objects
};

// Says what happens to a copy of a process when the original process ends.
enum class Orphan {
  kGoesOn,    // the copy goes on
  kIsKilled,  // the kernel kills the copy when the thread that has made it ends, also by a crash
};

// Makes a copy of this process.  Returns in both processes: 0 in the copy, and in the original the
// process id of the copy.  If the system gives no process, returns -1 and sets errno.
pid_t CopyProcess(Flushed flushed, Orphan orphan);

// Ends this process, which is a copy, with status 0: writes the text in the buffers of all streams,
// and runs no exit handlers and no destructors.
[[noreturn]] void EndCopy();

// Waits for the end of the child process `child` and returns its status as waitpid() gives it.
// REQUIRES: nothing else has waited for the end of `child`.
int WaitForEnd(pid_t child);

// Waits until this process has no child process.
void WaitForAllCopies();

// Returns the exit code in `status`, which waitpid() has given; kExitWrong if a signal has ended
// the process.
int ExitCodeOf(int status);

struct ProcessCopy {
  pid_t pid = -1;
  // The descriptor from which this process, the original, reads the answers of the copy.  The
  // caller of StartCopy() closes it.
  int answers = -1;
};

// Makes a copy of this process that sends its answers through a pipe.  All streams are flushed
// before.  The copy calls `work` with the writing end of the pipe, and then ends with status 0.
// Throws std::runtime_error when the system gives no pipe or no process.
// REQUIRES: the process has one thread.
ProcessCopy StartCopy(Orphan orphan, const std::function<void(int answers)>& work);

// Starts a program that is not a child of this process.  So this process need not wait for the end
// of the program, and no zombie is left.  For this, makes a copy of this process.  The copy calls
// `start`, which starts the program and returns 0 or an errno.  Then the copy ends.  Returns the
// reason why the program was not started; "" if it was started.
// REQUIRES: `start` calls only functions that are allowed after fork().
std::string StartThroughCopy(const std::function<int()>& start);

// Returns the text that is read from `descriptor` until its end or an error.  If `echo` is not
// null, also writes the text to `echo` as soon as it arrives.  Calls `while_waiting`, if this
// function is not null, about every 200 ms.
std::string ReadToEnd(int descriptor, std::FILE* echo = nullptr,
                      const std::function<void()>& while_waiting = {});

}  // namespace openr_host
