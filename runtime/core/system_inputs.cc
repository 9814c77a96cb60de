#include "runtime/core/system_inputs.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "runtime/base/characters.h"
#include "runtime/core/post_as_object.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// The largest size in bytes of a datum that the input `send` posts.  The limit is our choice: data
// that a person or a script sends are much smaller, and the limit bounds the memory that a command
// from outside can allocate.
constexpr size_t kDatumMax = size_t{64} << 10;

template <typename T>
void AppendBytes(T value, std::string* bytes) {
  bytes->append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <typename T>
std::string AppendWhole(std::string_view text, std::string* bytes) {
  int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || at != end) return fmt::format("'{}' is no whole number", text);
  // Accepts both signed and unsigned values, because the type of a value in an input, such as
  // "byte:255", says only how many bytes the value has.
  constexpr int kBits = 8 * sizeof(T);
  if constexpr (kBits < 64) {
    if (value < -(int64_t{1} << (kBits - 1)) || value >= int64_t{1} << kBits)
      return fmt::format("{} does not fit into {} bytes", value, sizeof(T));
  }
  AppendBytes(static_cast<T>(value), bytes);
  return "";
}

template <typename T>
std::string AppendReal(std::string_view text, std::string* bytes) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || at != end || !std::isfinite(value) ||
      std::abs(value) > static_cast<double>(std::numeric_limits<T>::max()))
    return fmt::format("'{}' is no number", text);
  AppendBytes(static_cast<T>(value), bytes);
  return "";
}

std::string AppendHex(std::string_view text, std::string* bytes) {
  if (text.empty() || text.size() % 2 != 0)
    return fmt::format("hex:{} needs two digits for each byte", text);
  for (size_t i = 0; i < text.size(); i += 2) {
    unsigned byte = 0;
    const auto [at, error] = std::from_chars(&text[i], &text[i] + 2, byte, 16);
    if (error != std::errc() || at != &text[i] + 2)
      return fmt::format("hex:{} has other characters than hexadecimal digits", text);
    bytes->push_back(static_cast<char>(byte));
  }
  return "";
}

// The datum that the input `send` posts, and the names of the subject and the observer of its
// connection.
struct SentDatum {
  int robot = 0;
  std::string observer;
  std::string subject;  // may be "" if the observer is connected with one subject only
  std::string bytes;
};

std::string ReadSentDatum(std::string_view rest, SentDatum* datum) {
  const std::vector<std::string> words = SplitInput(rest);
  if (words.empty()) return "names no observer";
  datum->observer = words[0];
  size_t at = 1;
  if (words.size() > 2 && words[1] == "from") {
    datum->subject = words[2];
    at = 3;
  }
  if (at == words.size()) return "has no value to send";
  for (; at < words.size(); ++at) {
    if (std::string problem = ReadMessageValue(words[at], &datum->bytes); !problem.empty())
      return problem;
    if (datum->bytes.size() > kDatumMax)
      return fmt::format("the values have more than {} bytes", kDatumMax);
  }
  return "";
}

// Finds the subject and the observer of the connection that `datum` names.  Returns "", or the
// reason why there is no such connection.
std::string FindEnds(const System& system, const SentDatum& datum, ServiceEnd* subject,
                     ServiceEnd* observer) {
  const auto to = FindService(system, datum.robot, datum.observer, ServiceSide::kObserver);
  if (!to) return fmt::format("no object has the observer '{}'", datum.observer);
  std::string name = datum.subject;
  if (name.empty()) {
    const std::vector<std::string> subjects = SubjectsOf(system, datum.robot, datum.observer);
    if (subjects.empty()) return fmt::format("'{}' has no connection", datum.observer);
    if (subjects.size() > 1)
      return fmt::format("'{}' is connected with {}; add 'from SUBJECT'", datum.observer,
                         fmt::join(subjects, ", "));
    name = subjects.front();
  }
  const auto from = FindService(system, datum.robot, name, ServiceSide::kSubject);
  if (!from) return fmt::format("no object has the subject '{}'", name);
  *subject = *from;
  *observer = *to;
  return "";
}

// Posts `datum`, which an input `send` has ordered.  Reports a failure as an error finding, because
// no caller waits for the result.
void Send(System* system, const SentDatum& datum) {
  ServiceEnd subject, observer;
  std::string problem = FindEnds(*system, datum, &subject, &observer);
  if (problem.empty()) problem = PostNotification(system, subject, observer, datum.bytes);
  if (problem.empty()) return;
  system->AddFindingAboutRobot(datum.robot, Severity::kError,
                               fmt::format("input: send: {}", problem));
}

std::string ReadSend(System* system, int robot, std::string_view rest, Inputs::Action* action) {
  SentDatum datum;
  datum.robot = robot;
  std::string problem = ReadSentDatum(rest, &datum);
  // Checks the names of subject and observer only if the boot is over, because objects register
  // their services during the boot.
  ServiceEnd subject, observer;
  if (problem.empty() && system->booted()) problem = FindEnds(*system, datum, &subject, &observer);
  *action = [system, datum] { Send(system, datum); };
  return problem;
}

// Returns "" if the terminal of `robot` has room for `text` now.  Otherwise returns the reason why
// not: programs have not read enough of the text that was typed before.
std::string CheckRoom(const ConsoleInput& console, int robot, std::string_view text) {
  const size_t room = console.RoomOf(robot);
  if (ConsoleInput::EnteredSize(text) <= room) return "";
  if (room == ConsoleInput::kUnreadMax)
    return fmt::format("the text has {} bytes with its newline; at most {} can wait to be read",
                       ConsoleInput::EnteredSize(text), ConsoleInput::kUnreadMax);
  return fmt::format(
      "no program of the robot reads the console: {} bytes of typed text wait already, and at most "
      "{} can wait",
      ConsoleInput::kUnreadMax - room, ConsoleInput::kUnreadMax);
}

std::string ReadType(System* system, int robot, std::string_view text, Inputs::Action* action) {
  ConsoleInput& console = system->console_input();
  if (std::string problem = CheckRoom(console, robot, text); !problem.empty()) return problem;
  // Reserves room on the terminal until `*action`, which runs at the next frame boundary, has typed
  // the text.  Otherwise several inputs that wait for the same frame boundary could have more text
  // than the terminal can hold.
  std::shared_ptr<const void> room = console.Reserve(robot, ConsoleInput::EnteredSize(text));
  *action = [&console, robot, text = std::string(text), room = std::move(room)] {
    console.Enter(robot, text);
  };
  return "";
}

}  // namespace

std::string ReadMessageValue(std::string_view word, std::string* bytes) {
  if (word.size() >= 2 && word.front() == '"' && word.back() == '"') {
    bytes->append(word.substr(1, word.size() - 2));
    return "";
  }
  const size_t colon = word.find(':');
  if (colon == std::string_view::npos) {
    return word.find_first_of(".eE") == std::string_view::npos ? AppendWhole<int32_t>(word, bytes)
                                                               : AppendReal<double>(word, bytes);
  }
  const std::string_view type = word.substr(0, colon), value = word.substr(colon + 1);
  if (type == "byte") return AppendWhole<int8_t>(value, bytes);
  if (type == "short") return AppendWhole<int16_t>(value, bytes);
  if (type == "int") return AppendWhole<int32_t>(value, bytes);
  if (type == "long") return AppendWhole<int64_t>(value, bytes);
  if (type == "float") return AppendReal<float>(value, bytes);
  if (type == "double") return AppendReal<double>(value, bytes);
  if (type == "hex") return AppendHex(value, bytes);
  return fmt::format("'{}' is no type; types are byte, short, int, long, float, double, hex", type);
}

std::string TypeText(System* system, int robot, std::string_view text) {
  return system->inputs().Add(robot, fmt::format("type {}", text));
}

void AddSystemInputs(System* system) {
  system->inputs().AddKind(
      Inputs::kEveryRobot,
      {"type", "type TEXT", "Types a line on the robot's terminal, for objects that read it.",
       [system](int robot, std::string_view rest, Inputs::Action* action) {
         return ReadType(system, robot, rest, action);
       }});
  system->inputs().AddKind(Inputs::kEveryRobot,
                           {"send", "send OBSERVER [from SUBJECT] VALUE...",
                            "Sends an observer one datum, as if a subject had notified it.",
                            [system](int robot, std::string_view rest, Inputs::Action* action) {
                              return ReadSend(system, robot, rest, action);
                            }});
  system->inputs().AddKind(
      Inputs::kEveryRobot,
      {"shutdown", "shutdown",
       "Shuts the robot down: DoStop and DoDestroy of all objects, then off.",
       [system](int robot, std::string_view rest, Inputs::Action* action) {
         *action = [system, robot] {
           system->Shutdown(robot,
                            {EndKind::kPowerOff, "the input 'shutdown' shut the robot down"});
         };
         return rest.empty() ? std::string() : fmt::format("takes no '{}'", rest);
       }});
}

}  // namespace openr_host
