// Rewind: goes back to an earlier moment of a run that goes on.
//
// While a client watches the run, the run forks now and then.  Each fork is a checkpoint: it only
// waits, and so keeps the state of its moment.  To show an earlier moment, the last checkpoint
// before the moment forks again.  This second fork is a view: it repeats the run up to the moment,
// with the inputs of the run, and answers requests.  Meanwhile the run waits.  A view can go on
// from its moment as a new run, a branch.  The first run then ends, but its process waits for the
// branch, so that a terminal sees one program.
//
//   openr run ----- checkpoint ----- view, later branch
//             \---- checkpoint
//
// A view and a branch have files and, later, ports of their own.  Everything that a copy must not
// share with the original process is in saved_files.h, branch_network.h and RewindParts.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "openr/rewind/input_log.h"
#include "openr/rewind/saved_files.h"
#include "runtime/base/temp_folder.h"

namespace openr_host {

class BranchNetwork;
class KnownRun;
class Network;
class Simulation;
class System;

// The run that can be rewound, and functions of other parts of the program, which Rewind calls.
struct RewindParts {
  Simulation* simulation = nullptr;
  std::string no_rewind_reason;  // the reason why this run cannot be rewound; "": it can be rewound
  // The run, if it is a known run, such as the replay of a recording.  In a view (which shows a
  // past moment) and in a branch (a new run), the known run repeats its inputs.  Null: a view
  // repeats the logged inputs of this run.
  KnownRun* known = nullptr;
  // The longest virtual time by which the run can go back from the present.
  int64_t span_us = 60'000'000;
  // A function that answers the request of a client.  Called in a view, the process that shows a
  // past moment.
  std::function<nlohmann::ordered_json(const nlohmann::json& request)> answer;
  // A function that is called in the process of a new checkpoint.  It makes this process print
  // nothing, and close the sockets of clients, because only the original process may use them.
  std::function<void()> become_copy;
  // A function that is called in a new view, the process that shows a past moment.  It gets the
  // files of the stick that objects have changed in the original run, with the content from before
  // the first change.
  std::function<void(const SavedStick& changed)> become_view;
  // A function that is called after each frame that a view, the process that shows a past moment,
  // runs.
  std::function<void()> after_frame;
  // A function that is called in a view, the process that shows a past moment, before an input line
  // is repeated.
  std::function<void(int robot, const std::string& line)> before_input;
  // A function that turns a view, the process that shows a past moment, into a branch: a run of its
  // own, which is to go on at `rate`.  Returns the name of the new run.
  std::function<std::string(double rate)> become_branch;
};

class Rewind {
 public:
  Rewind();
  ~Rewind();
  Rewind(const Rewind&) = delete;
  Rewind& operator=(const Rewind&) = delete;

  // Returns the network that robot number `robot` must use instead of `inner`.  Called while the
  // simulation is made.
  std::unique_ptr<Network> WrapNetwork(int robot, std::unique_ptr<Network> inner);

  // Begins to log the inputs of the run that `parts` describes, and to save files of its stick
  // before their first change.  Does neither if this run cannot be rewound.  REQUIRES:
  // System::Boot() has not been called.
  void Begin(RewindParts parts);

  // Makes a checkpoint if the last checkpoint is old enough, and drops old checkpoints.  Drops all
  // checkpoints if no client watches the run.  Called after each frame.  Returns false in the
  // original run.  Returns again, with true, in a branch, a copy that goes on as a run of its own.
  bool AfterFrame(bool is_watched);

  // Refuses all later requests to go back to an earlier moment of the run, for the reason `why`.
  // If `why` is "", allows such requests again.
  void Refuse(std::string why) { refusal_ = std::move(why); }

  // Returns the state of Rewind for clients: whether and how far the run can be rewound, the number
  // and memory of the checkpoints, and the moment that is shown.
  nlohmann::ordered_json Status();

  // Returns the inputs that are kept to be repeated.
  const InputLog& log() const { return log_; }

  bool shows_past() const { return shown_ != nullptr; }
  // Shows clients the run as it was at the virtual time `time_us`.  Returns "", or the reason why
  // this moment cannot be shown.
  std::string ShowTime(int64_t time_us);
  // Shows clients the run as it was after `count` messages.  Returns "", or the reason why this
  // moment cannot be shown.
  std::string ShowMessage(uint64_t count);
  // Ends the view of a past moment.  Clients then see the present state of the run again.  The run
  // itself stays stopped.
  void ShowPresent();
  // Returns the virtual time of the past moment that is shown.
  int64_t shown_us() const { return shown_us_; }
  // Returns the number of messages up to the past moment that is shown.
  uint64_t shown_messages() const { return shown_messages_; }

  // Passes `request` to the process that shows a past moment, and returns the answer of this
  // process.  REQUIRES: shows_past().
  nlohmann::ordered_json Forward(const nlohmann::json& request);

  // Makes the view of a past moment a new run (a branch), which goes on at `rate` in place of this
  // run.  Returns {"run": NAME, "files": [PATH, ...]}, or {"error": TEXT}.  After success, the
  // caller must end this run and call WaitForBranch().
  nlohmann::ordered_json Branch(double rate);
  bool has_branched() const { return branch_ > 0; }
  // Waits until the branch, the process that goes on in place of this run, ends, and returns its
  // exit code.  `interrupts` returns how many signals to end this process have come.  Each time
  // this number has grown, the branch gets SIGTERM.
  int WaitForBranch(const std::function<int()>& interrupts);

 private:
  struct Checkpoint {
    pid_t process;
    int socket;
    int64_t time_us;
    uint64_t messages;
    uint64_t log_end;  // number of the first logged input after the checkpoint
  };

  System& system() const;
  // Returns the reason why the run cannot be rewound now; "" if it can be rewound.
  const std::string& RewindProblem() const;
  bool MakeCheckpoint();
  void Drop(Checkpoint* checkpoint);
  void DropOld();
  void UpdateMemory();
  void LeaveView();
  std::string Show(Checkpoint* checkpoint, const nlohmann::json& target);
  Checkpoint* LastBefore(int64_t time_us, uint64_t messages);

  // The functions from Wait() to GoOn() run in the process of a checkpoint or of a view.
  void Wait(int socket, const SavedStick& stick, ProcessFiles* files);
  bool RunView(int socket, const SavedStick& stick, ProcessFiles* files,
               const nlohmann::json& request);
  void Prepare(const SavedStick& stick, ProcessFiles* files, const nlohmann::json& request);
  void RunTo(const nlohmann::json& target);
  void RunOne(int64_t time_us);
  void AddDueInputs();
  nlohmann::json GoOn(ProcessFiles* files, double rate);

  RewindParts parts_;
  InputLog log_;
  // Network of each robot; the index is the number of the robot.
  std::vector<BranchNetwork*> networks_;
  // Files that objects have changed in this run, with the content from before the first change.
  SavedStick original_files_;
  std::deque<Checkpoint> checkpoints_;  // all checkpoints, in order of time
  // The checkpoint whose view clients see; null: they see the present.
  Checkpoint* shown_ = nullptr;
  int64_t shown_us_ = 0;
  uint64_t shown_messages_ = 0;
  int64_t next_ns_ = 0;  // earliest time of the next checkpoint, by the clock of this computer
  int64_t memory_ns_ = 0;
  size_t memory_bytes_ = 0;
  // Process of the branch, the run that goes on in place of this run; -1: none.
  pid_t branch_ = -1;
  // Process of the checkpoint that made the branch; a child of this process.
  pid_t branch_parent_ = -1;
  std::string trouble_;  // reason why no more checkpoints can be made; "": they can be made
  std::string refusal_;  // reason that was given to Refuse(); "": requests are allowed

  bool is_view_ = false;
  int64_t last_frame_us_ = 0;           // end of the last frame that this view has run
  std::deque<LoggedInput> lines_;       // input lines that this view has still to repeat
  std::unique_ptr<TempFolder> folder_;  // has this view's copies of the stick and of open files
};

}  // namespace openr_host
