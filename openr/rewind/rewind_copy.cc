// The part of Rewind that runs in the copies of a run: checkpoints, views and branches.
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "cli/json_text.h"
#include "cli/process_copy.h"
#include "openr/rewind/branch_network.h"
#include "openr/rewind/message_pipe.h"
#include "openr/rewind/rewind.h"
#include "openr/simulation/known_run.h"
#include "openr/simulation/run_stick.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

using PlainJson = nlohmann::json;

}  // namespace

// Runs the process of a checkpoint: waits, and makes a view (a process that shows a past moment)
// when the original run asks for it.  Returns only in a view that has become a branch, a run of its
// own.
void Rewind::Wait(int socket, const SavedStick& stick, ProcessFiles* files) {
  // Makes this copy of the run ignore signals of the terminal, because the original process handles
  // them.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_IGN);
  for (const Checkpoint& checkpoint : checkpoints_) close(checkpoint.socket);
  checkpoints_.clear();
  for (BranchNetwork* const network : networks_) network->Forget();
  parts_.become_copy();
  int exit_code = 0;
  for (;;) {
    const std::optional<PlainJson> request = ReceiveMessage(socket, -1);
    // Ends this process when the original run has closed its end of the socket: the original run is
    // over, or the last view has become a branch, and the branch is over.  In the second case,
    // `exit_code` is the exit code of the branch.
    if (!request) _exit(exit_code);
    if (!request->contains("show")) {
      SendMessage(socket, {{"error", "no view is open"}});
      continue;
    }
    const pid_t view = CopyProcess(Flushed::kNone, Orphan::kIsKilled);
    if (view == 0) {
      if (RunView(socket, stick, files, *request)) return;
      folder_.reset();
      _exit(0);
    }
    if (view < 0) {
      SendMessage(socket, {{"error", "the process cannot be copied"}});
      continue;
    }
    exit_code = ExitCodeOf(WaitForEnd(view));
  }
}

// Runs a view of a past moment.  `request` is the first request to the view.  Returns true when the
// view has become a branch, a run of its own, and false when the view must end.
bool Rewind::RunView(int socket, const SavedStick& stick, ProcessFiles* files,
                     const PlainJson& request) {
  is_view_ = true;
  last_frame_us_ = system().now_us();
  for (std::optional<PlainJson> next = request; next; next = ReceiveMessage(socket, -1)) {
    if (next->contains("leave")) {
      folder_.reset();
      SendMessage(socket, {{"left", true}});
      return false;
    }
    PlainJson answer;
    bool has_failed = false;
    try {
      if (next->contains("inputs")) Prepare(stick, files, *next);
      if (next->contains("show")) {
        RunTo(next->at("show"));
        answer = {{"time_us", system().now_us()}, {"messages", system().message_count()}};
      } else if (next->contains("branch")) {
        answer = GoOn(files, next->at("branch"));
      } else {
        answer = {{"line", JsonText(parts_.answer(next->at("answer")))}};
      }
    } catch (const std::exception& error) {
      answer = {{"error", error.what()}};
      // Does not end a view that has refused a request "answer" or "branch", because this view
      // still shows its moment.  Ends a view that could not reach the moment that it was to show.
      has_failed = !next->contains("answer") && !next->contains("branch");
    }
    SendMessage(socket, answer);
    if (has_failed) return false;
    if (next->contains("branch") && !answer.contains("error")) {
      close(socket);
      return true;
    }
  }
  return false;
}

// Gives the view files of its own, and the inputs that it must repeat.  `request` has these inputs,
// and the files that objects have changed in the original run, with the content from before the
// first change.
void Rewind::Prepare(const SavedStick& stick, ProcessFiles* files, const PlainJson& request) {
  folder_ = std::make_unique<TempFolder>();
  const std::string copy = folder_->path() + "/stick", temporary = folder_->path() + "/files";
  std::filesystem::create_directory(copy);
  std::filesystem::create_directory(temporary);
  auto* const present = dynamic_cast<FolderStick*>(system().robot(0).stick.get());
  const std::string root = present->root();
  CopyStick(root, copy);
  // Undoes in the copy of the stick all changes that objects have made since the beginning of the
  // run, because the view has not come to the changes after the checkpoint yet.  The changes before
  // the checkpoint are made again below.
  const SavedStick changed = SavedStick::Of(request.at("files"));
  changed.CopyTo(copy);
  stick.CopyTo(copy);  // restores the files that objects had changed before the checkpoint
  files->OpenAgain(root, copy, temporary);
  for (int robot = 0; robot < system().robot_count(); ++robot)
    dynamic_cast<FolderStick*>(system().robot(robot).stick.get())->set_root(copy);
  if (parts_.become_view) parts_.become_view(changed);
  std::vector<std::deque<LoggedInput>> network_inputs(networks_.size());
  for (LoggedInput& input : LoggedInputsOf(request.at("inputs"))) {
    if (input.poll == 0) {
      lines_.push_back(std::move(input));
    } else {
      network_inputs.at(static_cast<size_t>(input.robot)).push_back(std::move(input));
    }
  }
  for (size_t i = 0; i < networks_.size(); ++i) networks_[i]->Repeat(std::move(network_inputs[i]));
}

// Gives this view, a run that is played again, the input lines that the original run received at
// the moment at which the view is now: at the same time and after the same number of messages.
void Rewind::AddDueInputs() {
  while (!lines_.empty() && lines_.front().time_us == system().now_us() &&
         lines_.front().messages == system().message_count()) {
    const LoggedInput input = std::move(lines_.front());
    lines_.pop_front();
    parts_.before_input(input.robot, input.line);
    const std::string problem = system().inputs().Add(input.robot, input.line);
    if (!problem.empty())
      throw std::runtime_error(
          fmt::format("the input '{}' is refused now: {}", input.line, problem));
  }
}

// Repeats in this view the run up to a virtual time or up to a number of messages.  If the end is a
// virtual time, also repeats the messages that are due exactly at this time.
void Rewind::RunTo(const PlainJson& target) {
  const bool has_time = target.contains("time_us");
  const int64_t end_us = has_time ? target["time_us"].get<int64_t>() : INT64_MAX;
  const uint64_t end_count = has_time ? UINT64_MAX : target["messages"].get<uint64_t>();
  while (system().message_count() < end_count && !system().powered_off()) {
    const uint64_t before = system().message_count();
    const int64_t now_us = system().now_us();
    RunOne(now_us);
    if (system().message_count() != before) continue;
    // Ends the frame of 8 ms now, because no more messages are due at this time.
    if (now_us % kFrameUs == 0 && std::exchange(last_frame_us_, now_us) != now_us)
      parts_.after_frame();
    if (now_us >= end_us) return;
    const int64_t frame_end_us = (now_us / kFrameUs + 1) * kFrameUs;
    RunOne(std::min(frame_end_us, end_us));
    // Returns when RunOne() has neither advanced the time nor delivered a message, because then the
    // run is over.
    if (system().now_us() == now_us && system().message_count() == before) return;
  }
}

// Repeats in this view the inputs that are due now.  Then delivers the next message if it is due by
// `time_us`.
void Rewind::RunOne(int64_t time_us) {
  if (parts_.known != nullptr) return parts_.known->RunOne(time_us);
  AddDueInputs();
  system().RunOne(time_us);
}

// Makes the view a run of its own, which goes on at `rate`.  Returns the answer to the client that
// has asked for this run.
PlainJson Rewind::GoOn(ProcessFiles* files, double rate) {
  const std::vector<std::string> kept = files->KeepCopies();
  const std::string name = parts_.become_branch(rate);
  for (BranchNetwork* const network : networks_) network->GoOn();
  is_view_ = false;
  lines_.clear();
  log_.DropBefore(log_.end());
  // Lets the branch take a checkpoint at its first frame, because it begins without any.
  next_ns_ = 0;
  return {{"run", name}, {"files", kept}, {"process", getpid()}};
}

}  // namespace openr_host
