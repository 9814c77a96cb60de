#include "runtime/core/inputs.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/base/assert.h"
#include "runtime/base/characters.h"
#include "runtime/base/hasher.h"
#include "runtime/base/spelling.h"
#include "runtime/core/system.h"

namespace openr_host {

void Inputs::AddKind(int robot, Kind kind) {
  ASSERT(FindKind(robot, kind.name) == nullptr, "robot {} has the kind of input '{}'", robot,
         kind.name);
  std::pair key(robot, kind.name);
  kinds_.emplace(std::move(key), std::move(kind));
}

const Inputs::Kind* Inputs::FindKind(int robot, const std::string& name) const {
  for (const int owner : {robot, kEveryRobot}) {
    if (const auto found = kinds_.find({owner, name}); found != kinds_.end()) return &found->second;
  }
  return nullptr;
}

std::vector<const Inputs::Kind*> Inputs::KindsOf(int robot) const {
  std::vector<const Kind*> kinds;
  for (const auto& [key, kind] : kinds_) {
    if (key.first == robot || key.first == kEveryRobot) kinds.push_back(&kind);
  }
  std::sort(kinds.begin(), kinds.end(),
            [](const Kind* a, const Kind* b) { return a->name < b->name; });
  return kinds;
}

std::string Inputs::Read(int robot, std::string_view line, Action* action) const {
  const size_t end = std::min(line.find(' '), line.size());
  const std::string name(line.substr(0, end));
  if (robot < 0 || robot >= std::max(1, system_->robot_count()))
    return fmt::format("there is no robot {}; this run has {}", robot, system_->robot_count());
  const Kind* const kind = FindKind(robot, name);
  if (kind == nullptr) {
    std::vector<std::string> known;
    for (const Kind* const each : KindsOf(robot)) known.push_back(each->name);
    return fmt::format("'{}' is no input{}; known are {}", name, DidYouMean(name, known),
                       fmt::join(known, ", "));
  }
  const std::string_view rest = end == line.size() ? "" : line.substr(end + 1);
  const std::string problem = kind->read(robot, rest, action);
  return problem.empty() ? "" : fmt::format("{}: {}; usage: {}", name, problem, kind->usage);
}

std::string Inputs::Check(int robot, std::string_view line) const {
  Action action;
  return Read(robot, line, &action);
}

std::string Inputs::Add(int robot, std::string_view line) {
  ASSERT(t_current.object == nullptr, "input '{}' in a handler of {}", line,
         t_current.object->name);
  Action action;
  std::string problem = Read(robot, line, &action);
  if (!problem.empty()) return problem;
  // Passes the line of the input to the listeners, such as a recording, when the input is given and
  // not when it is due, because a recording stores the time at which it was given.
  for (const Listener& listener : listeners_) listener(robot, line);
  const int64_t frame_us = system_->frame_us();
  const int64_t due_us = (system_->now_us() + frame_us - 1) / frame_us * frame_us;
  Insert({due_us, robot, std::string(line), std::move(action)});
  return "";
}

// Inserts `input` into the list of waiting inputs, after all inputs that are due at the same time
// or earlier.
void Inputs::Insert(WaitingInput input) {
  const auto place = std::upper_bound(
      waiting_.begin(), waiting_.end(), input.due_us,
      [](int64_t due_us, const WaitingInput& other) { return due_us < other.due_us; });
  waiting_.insert(place, std::move(input));
}

std::string Inputs::AddAt(int64_t time_us, int robot, std::string_view line) {
  ASSERT(time_us >= system_->now_us(), "an input for t={} us at t={} us", time_us,
         system_->now_us());
  Action action;
  std::string problem = Read(robot, line, &action);
  if (!problem.empty()) return problem;
  const int64_t frame_us = system_->frame_us();
  const int64_t due_us = (time_us + frame_us - 1) / frame_us * frame_us;
  Insert({due_us, robot, std::string(line), std::move(action)});
  return "";
}

void Inputs::DoDue() {
  while (NextUs() <= system_->now_us()) {
    // Removes the input from the list before its work is done, because this work may add inputs to
    // the list.
    const WaitingInput input = std::move(waiting_.front());
    waiting_.pop_front();
    input.action.work();
  }
}

void Inputs::DoBeforeBoot() {
  std::erase_if(waiting_, [this](const WaitingInput& input) {
    if (input.due_us > system_->now_us() || !input.action.is_before_boot) return false;
    input.action.work();
    return true;
  });
}

void Inputs::HashState(Hasher* hasher) const {
  for (const WaitingInput& input : waiting_) {
    hasher->Add(input.due_us);
    hasher->Add(input.robot);
    hasher->AddText(input.line);
  }
}

std::vector<std::string> SplitInput(std::string_view text) {
  std::vector<std::string> words;
  for (size_t at = 0; at < text.size();) {
    if (IsBlank(text[at])) {
      ++at;
      continue;
    }
    const size_t begin = at;
    bool is_quoted = false;
    for (; at < text.size() && (is_quoted || !IsBlank(text[at])); ++at) {
      if (text[at] == '"') is_quoted = !is_quoted;
    }
    words.emplace_back(text.substr(begin, at - begin));
  }
  return words;
}

}  // namespace openr_host
