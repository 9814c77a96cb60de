#include "openr/kit/check_controller.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <set>

#include "openr/kit/controller_sources.h"
#include "openr/kit/source_text.h"
#include "openr/kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr int kFrameMs = 8;

class ControllerCheck {
 public:
  explicit ControllerCheck(Remarks* remarks) : remarks_(remarks) {}

  void Run(const ControllerSources& sources) {
    remarks_->AddAll(sources.diagnostics);
    for (const fs::path& file : sources.files) ReadSource(file);
    if (texts_.empty()) return;
    for (const auto& [file, code] : texts_) {
      CheckSteps(file, code);
      CheckRunFunctions(file, code);
    }
    if (!has_main_) {
      remarks_->Warning(texts_.begin()->first, "no main() in any source: nothing will happen");
    } else if (!has_loop_) {
      remarks_->Warning(texts_.begin()->first,
                        "nobody calls robot_run(): main() runs once and that is all");
    }
  }

 private:
  void ReadSource(const fs::path& file) {
    static const std::regex kDefine("(?:^|\n)[ \t]*#[ \t]*define[ \t]+(\\w+)[ \t]+\\(?(\\d+)\\)?");
    static const std::regex kRun("\\brobot_run[ \t\r\n]*\\([ \t\r\n]*&?[ \t]*(\\w+)");
    static const std::regex kMain("\\bmain[ \t\r\n]*\\(");
    static const std::regex kLoop("\\brobot_(run|step)[ \t\r\n]*\\(");
    const std::optional<std::string> text = ReadText(file);
    if (!text) return;
    originals_[file] = *text;
    const std::string code = WithoutComments(*text);
    texts_[file] = code;
    for (std::sregex_iterator it(code.begin(), code.end(), kDefine), end; it != end; ++it)
      numbers_[(*it)[1]] = NumberOf((*it)[2]);
    for (std::sregex_iterator it(code.begin(), code.end(), kRun), end; it != end; ++it)
      run_functions_.insert((*it)[1]);
    has_main_ = has_main_ || std::regex_search(code, kMain);
    has_loop_ = has_loop_ || std::regex_search(code, kLoop);
  }

  // A number, or a name that #define gives one; -1 for anything else.
  int NumberOf(const std::string& word) const {
    const bool is_number =
        !word.empty() && word.size() < 8 &&
        std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (is_number) return std::stoi(word);
    const auto found = numbers_.find(word);
    return found == numbers_.end() ? -1 : found->second;
  }

  Place PlaceOf(const std::string& file, size_t at) const {
    const std::string& text = originals_.at(file);
    const size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
    const size_t end = std::min(text.find('\n', at), text.size());
    const auto before = text.begin() + static_cast<std::ptrdiff_t>(at);
    return {file, static_cast<int>(std::count(text.begin(), before, '\n')) + 1,
            static_cast<int>(at - begin) + 1, text.substr(begin, end - begin)};
  }

  void CheckTimeStep(const std::string& file, size_t at, const std::string& word) {
    const int ms = NumberOf(word);
    if (ms < 0 || (ms > 0 && ms % kFrameMs == 0)) return;
    remarks_->Add(Remark::Kind::kWarning, PlaceOf(file, at),
                  fmt::format("a time step of {} ms is no multiple of {}; it becomes {} ms", ms,
                              kFrameMs, std::max(1, (ms + kFrameMs / 2) / kFrameMs) * kFrameMs));
  }

  void CheckSteps(const std::string& file, const std::string& code) {
    static const std::regex kStep("\\brobot_step[ \t\r\n]*\\([ \t\r\n]*(\\w*)");
    for (std::sregex_iterator it(code.begin(), code.end(), kStep), end; it != end; ++it) {
      const auto at = static_cast<size_t>(it->position(0));
      const std::string step = (*it)[1].length() > 0 ? (*it)[1].str() : "64";
      remarks_->Add(
          Remark::Kind::kWarning, PlaceOf(file, at),
          fmt::format("robot_step() works on the host only: on the robot a method that waits hears "
                      "nothing any more, so main() ends here. Put the body of the loop into "
                      "\"int run(int ms)\", let it return {0} where the loop calls "
                      "robot_step({0}), and call robot_run(run) in place of the loop; what must "
                      "last from one round to the next becomes static",
                      step));
      CheckTimeStep(file, static_cast<size_t>(it->position(1)), (*it)[1]);
    }
  }

  // What the functions given to robot_run() return.
  void CheckRunFunctions(const std::string& file, const std::string& code) {
    static const std::regex kReturn("\\breturn[ \t\r\n(]+(\\w+)[ \t\r\n)]*;");
    for (const std::string& name : run_functions_) {
      const std::regex definition("\\b" + name + "[ \t\r\n]*\\([^)]*\\)[ \t\r\n]*\\{");
      std::smatch match;
      if (!std::regex_search(code, match, definition)) continue;
      const auto open = static_cast<size_t>(match.position(0) + match.length(0)) - 1;
      const size_t close = std::min(ClosingOf(code, open), code.size());
      const std::string body = code.substr(open, close - open);
      for (std::sregex_iterator it(body.begin(), body.end(), kReturn), end; it != end; ++it)
        CheckTimeStep(file, open + static_cast<size_t>(it->position(1)), (*it)[1]);
    }
  }

  Remarks* const remarks_;
  std::map<std::string, std::string> originals_, texts_;  // by file; the second without comments
  std::map<std::string, int> numbers_;                    // of #define
  std::set<std::string> run_functions_;
  bool has_main_ = false;
  bool has_loop_ = false;
};

}  // namespace

void CheckController(const std::string& folder, Remarks* remarks) {
  ControllerCheck(remarks).Run(FindControllerSources(folder));
}

}  // namespace openr_host
