// Inputs: what people, scripts and other programs do to a run, one line of text each.
//
// The first word of an input is its kind: "press chin for 300ms" is of the kind "press".  The rest
// are the arguments.  An input takes effect at a frame boundary, like all that comes
// from outside.  A recording stores the lines with their times, so a replay gives the same lines at
// the same times.  The runtime defines some kinds (system_inputs.h), a virtual robot defines the
// kinds of its body (virtualrobot/robot/hands.h).  docs/inputs.md lists all kinds.
#pragma once

#include <concepts>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace openr_host {

class Hasher;
class System;

class Inputs {
 public:
  // The work of an input.  `work` is called at the frame boundary at which the input takes effect,
  // outside all handlers.
  struct Action {
    Action() = default;
    // The constructor is not explicit, so that Kind::read can assign a lambda to an Action:
    // `*action = [this] { ... };`.
    template <std::invocable Work>
    requires(!std::same_as<std::remove_cvref_t<Work>, Action>) Action(Work&& work_in)
        : work(std::forward<Work>(work_in)) {}

    std::function<void()> work;
    // If true, and if the input is due when the robots boot, `work` is called before the boot
    // (DoBeforeBoot()).  If false, such an input takes effect after the messages of the boot.
    // REQUIRES for true: `work` adds no input, and it can be called in a handler of the object
    // manager.
    bool is_before_boot = false;
  };

  struct Kind {
    std::string name;   // the first word of the input: "press"
    std::string usage;  // the form of the input: "press NAME [N%] [for DURATION]"
    std::string help;   // description of the input: "Presses a sensor that people touch."
    // Parses `rest`, the text of an input for `robot` behind the kind and one blank.  Sets
    // `*action` and returns "", or returns a text about the error in `rest`.
    std::function<std::string(int robot, std::string_view rest, Action* action)> read;
  };

  // The value of `robot` in AddKind() for a kind of input that every robot has.
  static constexpr int kEveryRobot = -1;

  explicit Inputs(System* system) : system_(system) {}

  // Adds a kind, the first word of inputs such as "press chin", for one robot or for every robot.
  // REQUIRES: the robot has no kind of this name.
  void AddKind(int robot, Kind kind);

  // Returns the kinds (first words of inputs) of `robot` in order of their names.
  std::vector<const Kind*> KindsOf(int robot) const;

  // Returns "" if Add() would accept the input `line` now, or the reason why not.
  std::string Check(int robot, std::string_view line) const;

  // Adds the input `line` for `robot`.  The input takes effect at the next frame boundary, or at
  // once if the clock is at a frame boundary.  Returns "" if the input was added, otherwise a text
  // about the error in the line.  REQUIRES: not called in a handler.
  std::string Add(int robot, std::string_view line);

  // Adds the input `line` for the frame boundary at `time_us`, or the first frame boundary after
  // it.  No listener is called.  REQUIRES: not called in a handler, and `time_us` is not in the
  // past.
  std::string AddAt(int64_t time_us, int robot, std::string_view line);

  // Registers a `listener` that Add() calls with each line that it accepts.
  using Listener = std::function<void(int robot, std::string_view line)>;
  void OnAdd(Listener listener) { listeners_.push_back(std::move(listener)); }

  // Returns the time at which the next input takes effect, a frame boundary; INT64_MAX if no input
  // waits.
  int64_t NextUs() const { return waiting_.empty() ? INT64_MAX : waiting_.front().due_us; }
  // Does the work of all inputs that are due now.
  void DoDue();
  // Does the work of the inputs that are due and have Action::is_before_boot set.  Called when the
  // robots begin to boot.
  void DoBeforeBoot();

  void HashState(Hasher* hasher) const;

 private:
  struct WaitingInput {
    int64_t due_us;
    int robot;
    std::string line;
    Action action;
  };

  const Kind* FindKind(int robot, const std::string& name) const;
  std::string Read(int robot, std::string_view line, Action* action) const;
  void Insert(WaitingInput input);

  System* const system_;
  std::map<std::pair<int, std::string>, Kind> kinds_;  // the key is the robot and the kind's name
  std::deque<WaitingInput> waiting_;  // the inputs that wait, in the order of due_us
  std::vector<Listener> listeners_;
};

// Returns the words of `text`, which blanks separate.  Text in double quotes is one word, with its
// quotes.  If the end quote is missing, this word ends at the end of `text`.
std::vector<std::string> SplitInput(std::string_view text);

}  // namespace openr_host
