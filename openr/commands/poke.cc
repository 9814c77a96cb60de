// The commands openr poke and openr attach, for a run in another process.  `openr poke` sends one
// input to the run.  `openr attach` is a console, which sends each input that the user types.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/exit_code.h"
#include "cli/print_plain.h"
#include "cli/prompt.h"
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"
#include "openr/commands/input_words.h"
#include "openr/decode/decode_message.h"
#include "openr/live/live_client.h"
#include "runtime/base/terminal_text.h"
#include "virtualrobot/robot/faults.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

struct LiveFlags {
  std::string run;
  int robot = 0;
};

// Returns the text of the answer to the request "inputs": one line for each input that the robot
// knows.
std::string InputsText(const Json& answer) {
  const Json& inputs = answer.at("inputs");
  size_t width = 0;
  for (const Json& input : inputs)
    width = std::max(width, input.at("usage").get<std::string>().size());
  std::string text;
  for (const Json& input : inputs) {
    text += fmt::format("  {:<{}}  {}\n", input.at("usage").get<std::string>(), width,
                        input.at("help").get<std::string>());
  }
  return text;
}

std::string StatusText(const Json& answer) {
  std::string text = fmt::format(
      "t={:.3f} s, {} of {}, {} messages, {} findings\n", answer.at("time_s").get<double>(),
      answer.at("robots").get<int>(), answer.at("model").get<std::string>(),
      answer.at("messages").get<uint64_t>(), answer.at("findings").get<uint64_t>());
  for (const Json& line : answer.at("waits")) text += line.get<std::string>() + "\n";
  return text;
}

std::string ObjectsText(const Json& answer) {
  std::string text =
      fmt::format("{:<24} {:>9} {:>7}  {}\n", "object", "messages", "waiting", "state");
  for (const Json& object : answer.at("objects")) {
    const std::string why = object.at("waits_for").get<std::string>();
    text +=
        fmt::format("{:<24} {:>9} {:>7}  {}{}\n", object.at("name").get<std::string>(),
                    object.at("messages").get<uint64_t>(), object.at("waiting").get<int>(),
                    object.at("state").get<std::string>(), why.empty() ? "" : "; waits for " + why);
  }
  return text;
}

std::string ObjectText(const Json& answer) {
  std::string text = fmt::format(
      "{}: {} messages, {} dropped, {} waiting; state: {}\n", answer.at("name").get<std::string>(),
      answer.at("messages").get<uint64_t>(), answer.at("dropped").get<uint64_t>(),
      answer.at("waiting").get<int>(), answer.at("state").get<std::string>());
  for (const Json& link : answer.at("subjects")) {
    text +=
        fmt::format("  {} -> {}: {}, {} sent, {} waiting\n", link.at("service").get<std::string>(),
                    link.at("observer").get<std::string>(),
                    link.at("ready").get<bool>() ? "ready" : "not ready",
                    link.at("sent").get<uint64_t>(), link.at("waiting").get<uint64_t>());
  }
  for (const Json& link : answer.at("observers")) {
    text += fmt::format("  {} <- {}\n", link.at("service").get<std::string>(),
                        link.at("subject").get<std::string>());
  }
  for (const Json& finding : answer.at("findings"))
    text += "  " + finding.get<std::string>() + "\n";
  return text;
}

std::string SensorsText(const Json& answer) {
  std::string text;
  for (const Json& sensor : answer.at("sensors")) {
    text +=
        fmt::format("{:<16} {:>12}  {}\n", sensor.at("name").get<std::string>(),
                    sensor.at("value").get<int64_t>(), sensor.at("long_name").get<std::string>());
  }
  return text;
}

std::string JointsText(const Json& answer) {
  std::string text = fmt::format("{:<12} {:>9} {:>9}  {}\n", "joint", "degrees", "target", "gain");
  for (const Json& joint : answer.at("joints")) {
    text += fmt::format("{:<12} {:>9.2f} {:>9.2f}  {}\n", joint.at("name").get<std::string>(),
                        joint.at("deg").get<double>(), joint.at("target_deg").get<double>(),
                        joint.at("gain").get<bool>() ? "on" : "off");
  }
  return text;
}

std::string FindingsText(const Json& answer) {
  std::string text;
  for (const Json& finding : answer.at("findings")) {
    text += fmt::format(
        "{}: {} (t={:.3f} s): {}{}\n", finding.at("severity").get<std::string>(),
        finding.at("object").get<std::string>(), finding.at("time_s").get<double>(),
        finding.at("text").get<std::string>(),
        MessageInParentheses(finding.at("message").get<uint64_t>(), finding.value("said", "")));
  }
  return text.empty() ? "no findings\n" : text;
}

// The console of openr poke and openr attach: sends requests to one run and prints the answers.
class RunConsole {
 public:
  explicit RunConsole(const LiveFlags& flags)
      : robot_(flags.robot), client_(FindLiveRun(flags.run)) {}

  // Sends an input to the run and prints the time at which it takes effect.  Returns false after
  // printing an error.
  bool Do(const std::string& input) {
    return Print({{"do", "input"}, {"line", input}}, [&](const Json& answer) {
      return fmt::format("t={:.3f} s: {}\n", answer.at("time_s").get<double>(), input);
    });
  }

  bool ShowInputs() { return Print({{"do", "inputs"}}, &InputsText); }

  // Carries out a line that was typed: a command of the console or an input.  Returns false after
  // printing an error.
  bool Line(const std::string& line) {
    const size_t end = std::min(line.find(' '), line.size());
    const std::string word = line.substr(0, end);
    const std::string rest = end == line.size() ? "" : line.substr(end + 1);
    if (word == "status") return Print({{"do", word}}, &StatusText);
    if (word == "objects") return Print({{"do", word}}, &ObjectsText);
    if (word == "object") return Print({{"do", word}, {"name", rest}}, &ObjectText);
    if (word == "sensors") return Print({{"do", word}}, &SensorsText);
    if (word == "joints") return Print({{"do", word}}, &JointsText);
    if (word == "findings") return Print({{"do", word}}, &FindingsText);
    if (word == "robot") return ChooseRobot(rest);
    if (word != "help") return Do(line);
    PrintAnswer(
        "Looking: status, objects, object NAME, sensors, joints, findings\n"
        "robot N: the robot that the other lines are about; quit or Ctrl-D: the end\n"
        "Inputs:\n");
    return ShowInputs();
  }

  // Returns the words that may follow `words` in a line that the user types; the Tab key offers
  // them.
  std::vector<std::string> WordsAfter(const std::vector<std::string>& words);

 private:
  bool ChooseRobot(const std::string& number) {
    int robot = 0;
    const char* const end = number.data() + number.size();
    const auto [at, error] = std::from_chars(number.data(), end, robot);
    if (error != std::errc() || at != end) return PrintProblem("'" + number + "' is no number");
    robot_ = robot;
    return true;
  }

  bool PrintProblem(const std::string& problem) {
    PrintPlain(stderr, "openr: {}\n", problem);
    return false;
  }

  // Sends `request` to the run, as a request about the robot of this console, and returns the
  // answer.
  Json Ask(Json request) {
    request["robot"] = robot_;
    return client_.Ask(request);
  }

  // Sends `request` and returns names from the answer: the member `member` of each element of the
  // array `list`.  Returns an empty list if the answer has no such array.
  std::vector<std::string> NamesIn(const Json& request, const char* list, const char* member) {
    std::vector<std::string> names;
    const Json answer = Ask(request);
    if (!answer.contains(list)) return names;
    for (const Json& each : answer.at(list)) names.push_back(each.at(member).get<std::string>());
    return names;
  }

  // Returns the connected services of all objects.  If `list` is "subjects", returns the services
  // that send; if it is "observers", returns the services that receive.
  std::vector<std::string> Services(const char* list) {
    std::vector<std::string> names;
    for (const std::string& object : NamesIn({{"do", "objects"}}, "objects", "name")) {
      for (const std::string& name : NamesIn({{"do", "object"}, {"name", object}}, list, "service"))
        names.push_back(name);
    }
    return names;
  }

  // Returns the words that may come next in an input.  `usage` describes the input, such as "press
  // SENSOR [N%] [for DURATION]".  `before` are the words of the input that the user has typed
  // already.
  std::vector<std::string> WordsOf(const std::string& usage,
                                   const std::vector<std::string>& before);

  template <typename Text>
  bool Print(Json request, Text text) {
    const Json answer = Ask(std::move(request));
    if (answer.contains("error")) return PrintProblem(answer.at("error").get<std::string>());
    PrintAnswer(TerminalText(text(answer)));
    // Empties the output buffer at once, because a program may wait for the answer at the other end
    // of a pipe.
    FlushAnswer();
    return true;
  }

  int robot_;
  LiveClient client_;
};

std::vector<std::string> RunConsole::WordsAfter(const std::vector<std::string>& words) {
  const std::vector<std::string> usages = NamesIn({{"do", "inputs"}}, "inputs", "usage");
  if (words.empty()) {
    std::vector<std::string> commands = {"status",   "objects", "object", "sensors", "joints",
                                         "findings", "robot",   "help",   "quit"};
    for (const std::string& usage : usages) commands.push_back(usage.substr(0, usage.find(' ')));
    return commands;
  }
  if (words[0] == "object") {
    if (words.size() > 1) return {};
    return NamesIn({{"do", "objects"}}, "objects", "name");
  }
  for (const std::string& usage : usages) {
    if (usage.substr(0, usage.find(' ')) == words[0]) return WordsOf(usage, words);
  }
  return {};
}

std::vector<std::string> RunConsole::WordsOf(const std::string& usage,
                                             const std::vector<std::string>& before) {
  std::vector<std::string> words;
  const auto add = [&words](const std::vector<std::string>& names) {
    words.insert(words.end(), names.begin(), names.end());
  };
  for (const std::string& word : WordsInUsage(usage)) {
    if (word == "SENSOR") {
      add(NamesIn({{"do", "sensors"}}, "sensors", "name"));
    } else if (word == "JOINT") {
      add(NamesIn({{"do", "joints"}}, "joints", "name"));
    } else if (word == "OBSERVER") {
      if (before.size() == 1) add(Services("observers"));
    } else if (word == "SUBJECT") {
      if (before.back() == "from") add(Services("subjects"));
    } else if (word == "FAULT") {
      add(Faults::Names());
    } else if (std::islower(static_cast<unsigned char>(word[0])) != 0) {
      words.push_back(word);  // a word that the user types unchanged, such as "for"
    }
  }
  return words;
}

int RunPoke(const LiveFlags& flags, const std::vector<std::string>& words) {
  RunConsole console(flags);
  const bool good =
      words.empty() ? console.ShowInputs() : console.Do(fmt::format("{}", fmt::join(words, " ")));
  return good ? kExitGood : kExitWrong;
}

int RunAttach(const LiveFlags& flags) {
  RunConsole console(flags);
  const bool is_terminal = isatty(STDIN_FILENO) == 1;
  const std::string prompt = is_terminal ? flags.run + "> " : "";
  if (is_terminal) PrintAnswer("'help' lists what can be typed\n");
  FlushAnswer();
  PromptHistory history;
  Prompt lines(&history, [&console](const std::vector<std::string>& words, const std::string&) {
    return console.WordsAfter(words);
  });
  bool good = true;
  for (std::string line; lines.Read(prompt, &line) && line != "quit";) {
    if (!line.empty() && !console.Line(line)) good = false;
  }
  // Returns kExitGood if the user has typed the lines at a terminal, because the user has already
  // seen each error.  If the lines come from a script, returns kExitWrong after an error.
  return good || is_terminal ? kExitGood : kExitWrong;
}

void AddLiveFlags(CLI::App* command, LiveFlags* flags) {
  command->add_option("RUN", flags->run, "Name or process id of a run on this computer")
      ->required();
  command->add_option("--robot", flags->robot, "Number of the robot")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

}  // namespace

void AddPokeCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "poke", "Gives a run an input: openr poke RUN press chin for 300ms; without one, lists them");
  auto flags = std::make_shared<LiveFlags>();
  AddLiveFlags(command, flags.get());
  // Leaves the words of the input unparsed, because CLI11 would read the number -5 in "push 0 -5 0"
  // as a flag.
  command->prefix_command();
  command->callback(
      [command, flags, exit_code] { *exit_code = RunPoke(*flags, command->remaining()); });
}

void AddAttachCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("attach", "Console of a run: looks at its objects, gives it inputs");
  auto flags = std::make_shared<LiveFlags>();
  AddLiveFlags(command, flags.get());
  command->callback([flags, exit_code] { *exit_code = RunAttach(*flags); });
}

}  // namespace openr_host
