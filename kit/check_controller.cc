#include "kit/check_controller.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

#include "kit/check_objects.h"
#include "kit/controller_code.h"
#include "kit/controller_sources.h"
#include "kit/endless_loop.h"
#include "kit/robot_lacks.h"
#include "kit/source_place.h"
#include "kit/source_text.h"
#include "runtime/base/spelling.h"

namespace openr_host {
namespace {

constexpr int kFrameMs = 8;

// The part of a controller that a function belongs to.  kRun: a function passed to robot_run(), or
// called from such a function.  kDie: the same for robot_die().  kMain: all other functions.
enum class Part { kMain, kRun, kDie };

class ControllerCheck {
 public:
  ControllerCheck(const ControllerSources& sources, const std::vector<std::string>& locators,
                  Remarks* remarks)
      : code_(sources.files),
        locators_(locators),
        run_functions_(code_.FunctionsPassedTo("robot_run")),
        in_run_(code_.ReachedFrom(run_functions_)),
        in_die_(code_.ReachedFrom(code_.FunctionsPassedTo("robot_die"))),
        steps_(code_.CallersOf("robot_step")),
        remarks_(remarks) {}

  void Run() {
    if (code_.files().empty()) return;
    for (const CodeFile& file : code_.files()) {
      CheckSteps(file);
      CheckLoops(file);
      CheckCalls(file);
      CheckLocators(file);
      CheckStickPaths(file.name, file.source, remarks_);
    }
    CheckRunFunctions();
    const std::string& first = code_.files().front().name;
    if (!code_.Defines("main")) {
      remarks_->Warning(first, "no main() in any source: nothing will happen");
    } else if (!code_.Calls("robot_run") && !code_.Calls("robot_step")) {
      remarks_->Warning(first, "nothing calls robot_run(): main() runs once and that is all");
    }
  }

 private:
  Part PartOf(const CodeFunction* function) const {
    if (function == nullptr) return Part::kMain;
    if (in_run_.contains(function->name)) return Part::kRun;
    return in_die_.contains(function->name) ? Part::kDie : Part::kMain;
  }

  void Add(Remark::Kind kind, const CodeFile& file, size_t at, std::string text) {
    remarks_->Add(kind, ControllerCode::PlaceOf(file, at), std::move(text));
  }

  void CheckTimeStep(const CodeFile& file, size_t at, std::string_view word) {
    const int ms = code_.macros().NumberOf(word);
    if (ms < 0 || (ms > 0 && ms % kFrameMs == 0)) return;
    Add(Remark::Kind::kWarning, file, at,
        fmt::format("a time step of {} ms is no multiple of {}; it becomes {} ms", ms, kFrameMs,
                    std::max(1, (ms + kFrameMs / 2) / kFrameMs) * kFrameMs));
  }

  void CheckSteps(const CodeFile& file) {
    const std::string& code = file.code.text;
    for (const CodeCall& call : ControllerCode::CallsIn(code, 0, code.size())) {
      const CodeFunction* const function = code_.FunctionAt(file, call.at);
      if (call.name != "robot_step" || function == nullptr) continue;
      const size_t argument = std::min(NextOf(code, call.open + 1), code.size());
      const std::string_view step = WordAt(code, argument);
      const Part part = PartOf(function);
      Add(Remark::Kind::kWarning, file, call.at,
          part == Part::kMain ? LoopAdvice(step) : StepAdvice(part));
      if (part == Part::kMain) CheckTimeStep(file, argument, step);
    }
  }

  static std::string LoopAdvice(std::string_view step) {
    return fmt::format(
        "robot_step() works on the host only: on the robot a method that waits hears nothing any "
        "more, so main() ends here. Put the body of the loop into \"int run(int ms)\", let it "
        "return {0} where the loop calls robot_step({0}), and call robot_run(run) in place of the "
        "loop; what must last from one round to the next becomes static",
        step.empty() ? "64" : step);
  }

  static std::string StepAdvice(Part part) {
    if (part == Part::kDie) {
      return "robot_step() does nothing in the function of robot_die(): the dog is being shut "
             "down, nothing is commanded any more and no time passes. Leave it out";
    }
    return "robot_step() does nothing in the function of robot_run(), which has its step already: "
           "the ms that it returns. To wait in between, remember in a static variable how far it "
           "has come, return the ms to wait, and go on from there at the next call";
  }

  void CheckLoops(const CodeFile& file) {
    const std::string& code = file.code.text;
    const auto is_true = [this](std::string_view word) {
      return code_.macros().NumberOf(word) > 0;
    };
    for (const EndlessLoop& loop : FindEndlessLoops(code, is_true)) {
      const std::vector<CodeCall> calls = ControllerCode::CallsIn(code, loop.at, loop.end);
      const bool steps = std::any_of(calls.begin(), calls.end(), [this](const CodeCall& call) {
        return steps_.contains(call.name);
      });
      const CodeFunction* const function = code_.FunctionAt(file, loop.at);
      if (steps || function == nullptr) continue;
      Add(Remark::Kind::kError, file, loop.at,
          fmt::format(
              "{}() never returns from this loop: {}", function->name,
              loop.waits ? WaitAdvice(PartOf(function)) : EndlessLoopAdvice(PartOf(function))));
    }
  }

  static std::string WaitAdvice(Part part) {
    return fmt::format(
        "while a function of the controller runs no time passes, so what the loop waits for does "
        "not change. {} and look at it again at its next call",
        part == Part::kMain ? "Let \"int run(int ms)\", called by robot_run(run), return"
                            : "Return");
  }

  static std::string EndlessLoopAdvice(Part part) {
    return part == Part::kMain
               ? "no sensor changes meanwhile and no command goes out. Put the body of the loop "
                 "into \"int run(int ms)\", which returns the ms until its next call, and call "
                 "robot_run(run) in place of the loop"
               : "no sensor changes meanwhile and no command goes out. Do one round at each call; "
                 "the loop is that of robot_run()";
  }

  void CheckCalls(const CodeFile& file) {
    static const std::regex kStdThread("\\bstd[ \t]*::[ \t]*(thread|async)\\b");
    const std::string& code = file.code.text;
    for (std::sregex_iterator it(code.begin(), code.end(), kStdThread), end; it != end; ++it)
      AddLack(file, static_cast<size_t>(it->position(0)), "std::" + (*it)[1].str());
    for (const CodeCall& call : ControllerCode::CallsIn(code, 0, code.size())) {
      if (code_.FunctionAt(file, call.at) == nullptr || code_.Defines(call.name)) continue;
      const bool is_member = IsMember(code, call.at);
      if (!is_member) AddLack(file, call.at, call.name);
      // Among member functions only open() takes the name of a file as an argument, as in
      // stream.open("A.TXT").
      const bool opens = TakesFileName(call.name) && (!is_member || call.name == "open");
      if (opens || IsFileStream(code, call.at)) CheckFileName(file, call);
    }
  }

  static bool IsMember(const std::string& code, size_t at) {
    const size_t before = PreviousOf(code, at);
    return before != kNone &&
           (code[before] == '.' || (code[before] == '>' && before > 0 && code[before - 1] == '-'));
  }

  // Returns whether the word at `at` is the name of a new variable with a type such as
  // std::ifstream, as `file` in std::ifstream file("A.TXT").  The brackets after such a name
  // contain the name of a file.
  static bool IsFileStream(const std::string& code, size_t at) {
    size_t begin = PreviousOf(code, at);
    if (begin == kNone || begin + 1 == at) return false;
    while (begin > 0 && IsWordCharacter(code[begin - 1])) --begin;
    const std::string_view type = WordAt(code, begin);
    return type == "ifstream" || type == "ofstream" || type == "fstream";
  }

  // Checks the names of devices in a file.  These are the arguments of robot_get_device(), and all
  // strings that begin with "PRM:", because controllers keep such names in tables.
  void CheckLocators(const CodeFile& file) {
    if (locators_.empty()) return;
    for (const StringLiteral& literal : StringLiteralsIn(file.source)) {
      const size_t after = NextOf(file.source, literal.at + literal.text.size() + 2);
      const size_t before = PreviousOf(file.source, literal.at);
      // Skips strings that may be only a part of a device's name: strings next to another string,
      // strings with a format such as %d or an escape, and strings that end in '/', '-' or ':'.
      const bool is_joined = (after != kNone && file.source[after] == '"') ||
                             (before != kNone && file.source[before] == '"');
      const bool is_made_up = literal.text.find_first_of("%\\") != std::string::npos;
      const bool is_beginning = literal.text.find_last_of("/-:") + 1 == literal.text.size();
      if (is_joined || is_made_up || is_beginning) continue;
      if (literal.text.starts_with("PRM:") || IsGivenToGetDevice(file.source, before))
        CheckLocator(file, literal);
    }
  }

  // Returns whether the text up to the position `last` ends in "robot_get_device(".
  static bool IsGivenToGetDevice(const std::string& source, size_t last) {
    constexpr std::string_view kFunction = "robot_get_device";
    if (last == kNone || source[last] != '(') return false;
    const size_t end = PreviousOf(source, last);
    return end != kNone && end + 1 >= kFunction.size() &&
           HasWordAt(source, end + 1 - kFunction.size(), kFunction);
  }

  void CheckLocator(const CodeFile& file, const StringLiteral& literal) {
    if (std::find(locators_.begin(), locators_.end(), literal.text) != locators_.end()) return;
    remarks_->Add(Remark::Kind::kWarning, PlaceAt(file.name, file.source, literal.at),
                  fmt::format("no robot has a device '{}'; it reads 0, and what it is told goes "
                              "nowhere{}",
                              literal.text, DidYouMean(literal.text, locators_)));
  }

  void AddLack(const CodeFile& file, size_t at, const std::string& name) {
    const LackedCall* const lack = FindLackedCall(name);
    if (lack == nullptr) return;
    Add(lack->is_error ? Remark::Kind::kError : Remark::Kind::kWarning, file, at,
        fmt::format("{}(): {}", name, lack->why));
  }

  void CheckFileName(const CodeFile& file, const CodeCall& call) {
    const std::string argument = code_.FirstArgument(file, call);
    // Does not check the name of a device that is no string literal, because the name is known only
    // at run time.
    if (!argument.starts_with('"')) return;
    const std::string name = argument.substr(1, argument.find('"', 1) - 1);
    if (name.empty() || EqualsIgnoringCase(name.substr(0, 4), "/MS/")) return;
    const size_t slash = name.rfind('/');
    Add(Remark::Kind::kError, file, call.at,
        fmt::format("'{}' is no file of the Memory Stick: the robot has no working folder, and "
                    "names begin with /MS/. Write \"/MS/OPEN-R/MW/DATA/P/{}\"",
                    name, slash == kNone ? name : name.substr(slash + 1)));
  }

  // Checks the time steps, in ms, that are returned by the functions passed to robot_run().
  void CheckRunFunctions() {
    static const std::regex kReturn("\\breturn[ \t\r\n(]+(\\w+)[ \t\r\n)]*;");
    for (const CodeFunction& function : code_.functions()) {
      if (!run_functions_.contains(function.name)) continue;
      const std::string body =
          function.file->code.text.substr(function.begin, function.end - function.begin);
      for (std::sregex_iterator it(body.begin(), body.end(), kReturn), end; it != end; ++it) {
        CheckTimeStep(*function.file, function.begin + static_cast<size_t>(it->position(1)),
                      (*it)[1].str());
      }
    }
  }

  const ControllerCode code_;
  const std::vector<std::string>& locators_;  // names of all devices of all robots
  const std::set<std::string> run_functions_;
  // Names of the functions that are passed to robot_run() (in_run_) or to robot_die() (in_die_),
  // and of all functions that these call, directly or not.
  const std::set<std::string> in_run_, in_die_;
  const std::set<std::string> steps_;  // functions that call robot_step(), directly or not
  Remarks* const remarks_;
};

}  // namespace

void CheckController(const std::string& folder, const std::vector<std::string>& locators,
                     Remarks* remarks) {
  const ControllerSources sources = FindControllerSources(folder);
  remarks->AddAll(sources.diagnostics);
  ControllerCheck(sources, locators, remarks).Run();
}

}  // namespace openr_host
