#include "openr/run/event_script.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "cli/counted.h"
#include "runtime/base/characters.h"
#include "runtime/base/duration.h"
#include "runtime/base/read_file.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Removes the first word of `text`, and the blanks after this word, from `text`.  Returns the word.
std::string_view TakeWord(std::string_view* text) {
  size_t end = 0;
  while (end < text->size() && !IsBlank((*text)[end])) ++end;
  const std::string_view word = text->substr(0, end);
  while (end < text->size() && IsBlank((*text)[end])) ++end;
  text->remove_prefix(end);
  return word;
}

// Returns `line` without the blanks at both ends, and without a comment: a # that begins the line
// or comes after a blank, outside of quotes.
std::string_view WithoutComment(std::string_view line) {
  bool is_quoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') is_quoted = !is_quoted;
    if (line[i] == '#' && !is_quoted && (i == 0 || IsBlank(line[i - 1]))) line = line.substr(0, i);
  }
  while (!line.empty() && (IsBlank(line.back()) || line.back() == '\r')) line.remove_suffix(1);
  while (!line.empty() && IsBlank(line.front())) line.remove_prefix(1);
  return line;
}

constexpr std::string_view kByteOrderMarkOfText = "\xef\xbb\xbf";

}  // namespace

EventScript::EventScript(const std::string& file) {
  if (file.empty()) return;
  const std::optional<std::string> text = ReadFile(file);
  if (!text)
    throw std::runtime_error(fmt::format("{}: cannot be read: {}", file, std::strerror(errno)));
  if (text->starts_with(kByteOrderMarkOfText)) {
    throw std::runtime_error(file +
                             ":1: the file starts with a UTF-8 byte order mark; save it without");
  }
  std::istringstream lines(*text);
  std::string line;
  int64_t before_us = 0;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::string_view rest = WithoutComment(line);
    if (rest.empty()) continue;
    Event event{0, 0, "", fmt::format("{}:{}", file, number)};
    const auto fail = [&event](const std::string& what) {
      throw std::runtime_error(fmt::format("{}: {}", event.place, what));
    };
    std::string_view time = TakeWord(&rest);
    const bool is_relative = time.starts_with('+');
    if (is_relative) time.remove_prefix(1);
    if (const std::string problem = ParseDuration(time, &event.time_us); !problem.empty())
      fail(problem + ", the time of an input");
    if (is_relative) event.time_us += before_us;
    if (event.time_us < before_us) {
      fail(fmt::format("{} is before the time of the line above, {}", FormatDuration(event.time_us),
                       FormatDuration(before_us)));
    }
    before_us = event.time_us;
    if (rest.starts_with("robot ")) {
      TakeWord(&rest);
      const std::string_view word = TakeWord(&rest);
      const auto [end, error] =
          std::from_chars(word.data(), word.data() + word.size(), event.robot);
      if (error != std::errc() || end != word.data() + word.size())
        fail(fmt::format("'{}' is no number of a robot", word));
    }
    if (rest.empty()) fail("has a time and no input");
    event.input = rest;
    events_.push_back(std::move(event));
  }
}

std::string EventScript::Check(const System& system) const {
  for (const Event& event : events_) {
    const std::string problem = system.inputs().Check(event.robot, event.input);
    if (!problem.empty()) return fmt::format("{}: {}", event.place, problem);
  }
  return "";
}

void EventScript::Feed(System* system) {
  for (; !events_.empty() && events_.front().time_us <= system->now_us(); events_.pop_front()) {
    const Event& event = events_.front();
    const std::string problem = system->inputs().Add(event.robot, event.input);
    if (problem.empty()) continue;
    // Reports an error in this line of the script as a finding.  Check() could not find the error
    // before the run, because it cannot check names of services before the boot.
    system->AddFindingAboutRobot(event.robot, Severity::kError,
                                 fmt::format("{}: {}", event.place, problem));
  }
}

void EventScript::Skip(int robot, const std::string& input) {
  if (events_.empty()) return;
  const Event& next = events_.front();
  if (next.robot == robot && next.input == input) events_.pop_front();
}

void EventScript::ReportRest(System* system) const {
  if (events_.empty()) return;
  const Event& first = events_.front();
  system->AddFindingAbout(
      nullptr, Severity::kError,
      fmt::format("{}: the run was over before t={}; {} of the script did not happen", first.place,
                  FormatDuration(first.time_us), Counted(events_.size(), "input")));
}

}  // namespace openr_host
