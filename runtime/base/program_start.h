// ProgramStart: the start of another program in a process of its own.  All programs that the
// product starts are started by this class, so that the following holds for each of them.
//
// - Descriptors: the program has the standard streams of this process unless Give() or OpenNull()
//   gives it others.  The program also gets all other descriptors of this process, except those
//   that have the flag close-on-exec and those that CloseFrom() closes.
// - Memory: nothing of this process is copied, so the new process does not write text that this
//   process has buffered for output.
// - Signals: SIGPIPE and SIGXFSZ have their default actions, although this process ignores them,
//   because other programs, such as debuggers, expect that these signals end them.  Other signals
//   that this process ignores are ignored in the program, too.  Signals that this process blocks
//   are blocked in the program, too, unless UnblockSignals() is called.
// - End of this process: the program goes on.  Workers and the panel's server end themselves when
//   they notice this end: workers by openr join --child-of, the panel's server by a pipe.
// - End of the program: this process waits for the program's end with waitpid() or the like,
//   because the program stays as a zombie until then.
//
// A program that replaces this process (execv()) is not started by this class.
#pragma once

#include <spawn.h>
#include <sys/types.h>

#include <string>
#include <vector>

namespace openr_host {

class ProgramStart {
 public:
  // `words` are the arguments of the program.  The first word is the name by which the program was
  // called.  REQUIRES: `words` is not empty.
  explicit ProgramStart(std::vector<std::string> words);
  ~ProgramStart();
  ProgramStart(const ProgramStart&) = delete;
  ProgramStart& operator=(const ProgramStart&) = delete;

  // Each of the functions from OpenNull() to UnblockSignals() orders a step that the new process
  // takes before it begins the program.  The steps of OpenNull(), Give(), CloseFrom() and
  // EnterFolder() are taken in the order in which these functions were called.

  // Opens /dev/null as `descriptor`; `mode` is O_RDONLY, O_WRONLY or O_RDWR.
  void OpenNull(int descriptor, int mode);
  // Gives the program `ours`, a descriptor of this process.  In the program the descriptor has the
  // number `theirs`, and stays open when the program starts.  `ours` and `theirs` may be equal.
  void Give(int ours, int theirs);
  // Closes all descriptors of the new process from number `first` on, so that the program does not
  // have them.
  void CloseFrom(int first);
  // Makes `folder` the working folder of the program that this process starts.
  void EnterFolder(const std::string& folder);

  // Gives the program the environment `environment`, texts of the form "NAME=value".  Without this
  // call the program has the environment of this process.
  void SetEnvironment(std::vector<std::string> environment);
  // Gives the program a process group of its own, so that Ctrl-C on the terminal does not reach it.
  void LeaveGroup();
  // Gives the program a terminal session of its own (see setsid(2)), so that neither Ctrl-C nor the
  // end of the terminal reaches it.
  void LeaveSession();
  void UnblockSignals();

  // Starts the program in `file`, which is looked for in PATH unless it contains a '/'.  Sets
  // `*process` to the process id of the program and returns 0, or returns an errno.  Allocates no
  // memory, so that the child of a fork() may call this function even if its parent has several
  // threads.
  int Start(const std::string& file, pid_t* process) const;
  // Starts the program whose file is the first of the program's arguments, `words_`.
  int Start(pid_t* process) const { return Start(words_[0], process); }

 private:
  void AddFlag(short flag);

  const std::vector<std::string> words_;
  const std::vector<char*> arguments_;  // pointers to words_, and a null pointer
  std::vector<std::string> environment_;
  std::vector<char*> variables_;  // pointers to environment_ and null; empty until SetEnvironment()
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace openr_host
