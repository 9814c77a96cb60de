// ProgramStart: the start of another program in a process of its own.  All programs that the
// product starts are started by this class, so that the following holds for each of them.
//
// - Descriptors: the program has the standard streams of this process unless Give() or OpenNull()
//   gives it others.  Other descriptors that are not closed by the start of a program
//   (close-on-exec) reach the program, too, unless CloseFrom() closes them.
// - Buffered text of this process is not written, and nothing of this process is copied.
// - Signals: SIGPIPE and SIGXFSZ have their default actions.  This program ignores both, and a
//   child process would inherit that, but other programs, such as debuggers, expect that these
//   signals end them.  Other ignored signals stay ignored.  Signals that this process blocks are
//   blocked, unless UnblockSignals() is called.
// - End of this process: the program goes on.  A program that must end, too, finds out by itself:
//   workers by openr join --child-of, the panel's server by a pipe.
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

  // The following functions say what the new process does before the program begins.  The next four
  // functions take effect in the order in which they are called.

  // Opens /dev/null as `descriptor`; `mode` is O_RDONLY, O_WRONLY or O_RDWR.
  void OpenNull(int descriptor, int mode);
  // Makes `ours`, a descriptor of this process, the descriptor `theirs` of the program, which is
  // not closed by the start of the program.  The two may be equal.
  void Give(int ours, int theirs);
  // Closes all descriptors of the new process from number `first` on, so that the program does not
  // have them.
  void CloseFrom(int first);
  // Makes `folder` the working folder of the program that this process starts.
  void EnterFolder(const std::string& folder);

  // Replaces the environment, texts "NAME=value", which otherwise is the one of this process.
  void SetEnvironment(std::vector<std::string> environment);
  // Gives the program a process group of its own, so that Ctrl-C on the terminal does not reach it.
  void LeaveGroup();
  // Gives the program a terminal session of its own (see setsid(2)), so that neither Ctrl-C nor the
  // end of the terminal reaches it.
  void LeaveSession();
  void UnblockSignals();

  // Starts the program in `file`, which is looked for in PATH unless it contains a '/'.  Sets
  // `*process` to its process id and returns 0, or returns an errno.  Allocates no memory, so that
  // a copy of a process with several threads may call this function.
  int Start(const std::string& file, pid_t* process) const;
  // Starts the program whose file is the first word.
  int Start(pid_t* process) const { return Start(words_[0], process); }

 private:
  void AddFlag(short flag);

  const std::vector<std::string> words_;
  const std::vector<char*> arguments_;  // pointers to words_, and a null pointer
  std::vector<std::string> environment_;
  std::vector<char*> variables_;  // pointers to environment_, and a null pointer; else empty
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace openr_host
