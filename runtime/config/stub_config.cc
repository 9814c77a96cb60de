#include "runtime/config/stub_config.h"

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <utility>

#include "runtime/config/line_file.h"
#include "runtime/config/stub_line.h"

namespace openr_host {
namespace {

// The parser of a stub.cfg has one Side for the object's subjects and one for its observers.  A
// Side holds the declared number, and the services of the Service lines that were read so far.
struct Side {
  const char* noun;           // "subject" or "observer"
  const char* count_keyword;  // keyword in its usual spelling: "NumOfOSubject" or "NumOfOObserver"
  // End of a dummy service's name, such as ".DummySubject.DoNotConnect.S".
  const char* dummy_suffix;
  std::vector<StubService>* services;

  bool has_count = false;
  StubLine count_line = {};       // the NumOf... line, if has_count is true
  std::optional<int> count = {};  // declared number of services; nullopt if missing or invalid
};

class StubParser {
 public:
  StubParser() = default;
  StubParser(const StubParser&) = delete;
  StubParser& operator=(const StubParser&) = delete;

  StubConfigResult Parse(const std::string& file, std::string_view text);

 private:
  void ReadLine(const FilePosition& place);
  void FollowBlockComment(const FilePosition& place);
  void ReadObjectName(const StubLine& line);
  void ReadCount(const StubLine& line, Side* side);
  void ReadService(const StubLine& line);
  void ReadExtra(const StubLine& line);
  void CheckWhole(const std::string& file);
  void CheckCount(const std::string& file, const Side& side);
  void CheckExtra(const StubExtra& extra);

  void Error(const FilePosition& place, std::string message) {
    result_.diagnostics.push_back(ErrorAt(place, std::move(message)));
  }
  void Warning(const FilePosition& place, std::string message) {
    result_.diagnostics.push_back(WarningAt(place, std::move(message)));
  }

  StubConfigResult result_;
  Side subjects_{"subject", "NumOfOSubject", ".DummySubject.DoNotConnect.S",
                 &result_.config.subjects};
  Side observers_{"observer", "NumOfOObserver", ".DummyObserver.DoNotConnect.O",
                  &result_.config.observers};
  bool has_object_name_ = false;
  bool in_block_comment_ = false;
  // The line number of the last Service line that was ignored; 0 if none was ignored.  An error
  // about a wrong number of services names this line as the probable cause.
  int ignored_service_line_ = 0;
};

StubConfigResult StubParser::Parse(const std::string& file, std::string_view text) {
  for (const FilePosition& place : SplitLines(file, text, &result_.diagnostics)) ReadLine(place);
  CheckWhole(file);
  return std::move(result_);
}

void StubParser::ReadLine(const FilePosition& place) {
  FollowBlockComment(place);
  const std::optional<StubLine> line = RecognizeStubLine(place, &result_.diagnostics);
  if (!line) return;
  if (in_block_comment_) {
    Warning(place, "line holds although it is between /* and */; put '//' before it");
  }
  switch (line->keyword) {
    case StubKeyword::kObjectName:
      ReadObjectName(*line);
      break;
    case StubKeyword::kNumOfSubject:
      ReadCount(*line, &subjects_);
      break;
    case StubKeyword::kNumOfObserver:
      ReadCount(*line, &observers_);
      break;
    case StubKeyword::kService:
      ReadService(*line);
      break;
    case StubKeyword::kExtra:
      ReadExtra(*line);
      break;
  }
}

// Tracks whether the lines of the stub.cfg are between /* and */. Sony's stub generator for PCs
// ignores these lines as a comment, but the generator for the robot reads them.  So this parser
// reads them too, with a warning.
void StubParser::FollowBlockComment(const FilePosition& place) {
  const size_t open = place.text.rfind("/*");
  const size_t close = place.text.rfind("*/");
  const bool opens = open != std::string::npos && open == place.text.find_first_not_of(" \t");
  if (opens && (close == std::string::npos || close < open)) {
    in_block_comment_ = true;
  } else if (close != std::string::npos) {
    in_block_comment_ = false;
  }
}

void StubParser::ReadObjectName(const StubLine& line) {
  if (has_object_name_) {
    Warning(line.place, fmt::format("ObjectName again, after line {}; this line holds",
                                    result_.config.object_name_place.line));
  }
  has_object_name_ = true;
  result_.config.object_name = ParseObjectName(line, &result_.diagnostics);
  result_.config.object_name_place = line.place;
}

void StubParser::ReadCount(const StubLine& line, Side* side) {
  if (side->has_count) {
    Warning(line.place, fmt::format("{} again, after line {}; this line holds", line.word,
                                    side->count_line.place.line));
  }
  side->has_count = true;
  side->count_line = line;
  side->count = ParseCount(line, &result_.diagnostics);
}

void StubParser::ReadService(const StubLine& line) {
  const std::optional<StubService> service = ParseService(line, &result_.diagnostics);
  if (!service) {
    ignored_service_line_ = line.place.line;
    return;
  }
  const bool is_subject = service->name.is_subject();
  const Side& side = is_subject ? subjects_ : observers_;
  for (const StubService& other : *side.services) {
    if (other.name.short_name != service->name.short_name) continue;
    Error(service->place, fmt::format("a second {} '{}', after line {}: both would be {}{}; rename "
                                      "one",
                                      side.noun, service->name.short_name, other.place.line,
                                      is_subject ? "sbj" : "obs", service->name.short_name));
    break;
  }
  side.services->push_back(*service);
}

void StubParser::ReadExtra(const StubLine& line) {
  const std::optional<StubExtra> extra = ParseExtra(line, &result_.diagnostics);
  if (!extra) return;
  for (const StubExtra& other : result_.config.extras) {
    if (other.function != extra->function) continue;
    Error(extra->place, fmt::format("Extra {}() again, after line {}; remove one", extra->function,
                                    other.place.line));
    return;
  }
  result_.config.extras.push_back(*extra);
}

void StubParser::CheckWhole(const std::string& file) {
  const StubConfig& config = result_.config;
  if (!has_object_name_) {
    Error(FilePosition{file, 0, 0, ""},
          "no ObjectName line; add: ObjectName : <the object's C++ class>");
  }
  CheckCount(file, subjects_);
  CheckCount(file, observers_);
  for (const StubExtra& extra : config.extras) CheckExtra(extra);
  if (config.NumOfSelectors() > kSelectorsMax) {
    Warning(config.object_name_place,
            fmt::format("{} entry points, the robot has {} selectors for an object",
                        config.NumOfSelectors(), kSelectorsMax));
  }
}

void StubParser::CheckCount(const std::string& file, const Side& side) {
  const int found = static_cast<int>(side.services->size());
  const std::string& object = result_.config.object_name;
  // Wants a dummy subject in an object without subjects, and a dummy observer in an object without
  // observers, because the SDK's stub needs at least one of each.
  const std::string dummy =
      found > 0 ? ""
                : fmt::format(
                      "; every object needs at least one {}, add: Service : \"{}{}\", "
                      "null, null",
                      side.noun, object.empty() ? "Object" : object, side.dummy_suffix);
  if (!side.has_count) {
    Error(FilePosition{file, 0, 0, ""},
          fmt::format("no {0} line; add: {0} : {1}{2}", side.count_keyword, found == 0 ? 1 : found,
                      dummy));
    return;
  }
  if (!side.count) return;  // ParseCount() has already reported that the number is bad
  const int count = *side.count;
  const std::string& word = side.count_line.word;
  if (count == 0 && found == 0) {
    Error(side.count_line.place, fmt::format("{} is 0{}, and write 1 here", word, dummy));
    return;
  }
  std::string remedy;
  if (found < count) {
    remedy = "correct the number or add the missing Service line";
  } else if (found > count) {
    remedy = "correct the number";
  } else {
    return;
  }
  if (ignored_service_line_ > 0) remedy = fmt::format("line {} was ignored", ignored_service_line_);
  Error(side.count_line.place, fmt::format("{} is {}, but the file has {} {}{}; {}", word, count,
                                           found, side.noun, found == 1 ? "" : "s", remedy));
}

// Reports an Extra line whose function has the name of another entry, such as Ready0.  The stub
// declares a C function _X for each entry X, so it would have two functions of the same name and
// not compile.
void StubParser::CheckExtra(const StubExtra& extra) {
  std::vector<std::string> taken = {"Init",    "Start", "Stop",    "Destroy", "Hook",
                                    "Control", "Ready", "Connect", "Notify"};
  for (size_t i = 0; i < result_.config.subjects.size(); ++i) {
    taken.push_back(fmt::format("Control{}", i));
    taken.push_back(fmt::format("Ready{}", i));
  }
  for (size_t i = 0; i < result_.config.observers.size(); ++i) {
    taken.push_back(fmt::format("Connect{}", i));
    taken.push_back(fmt::format("Notify{}", i));
  }
  for (const std::string& name : taken) {
    if (extra.function != name) continue;
    Error(extra.place,
          fmt::format("Extra {0}() would be _{0} in the stub, which is taken; rename it", name));
  }
}

}  // namespace

int StubConfig::NumOfSelectors() const {
  return static_cast<int>(4 + 2 * (subjects.size() + observers.size()) + extras.size());
}

StubConfigResult ParseStubConfig(const std::string& file, std::string_view text) {
  return StubParser().Parse(file, text);
}

}  // namespace openr_host
