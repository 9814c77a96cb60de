#include "runtime/config/stub_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>

#include "runtime/base/characters.h"
#include "runtime/base/spelling.h"
#include "runtime/config/line_file.h"

namespace openr_host {
namespace {

// The largest number of services that a NumOf... line of stub.cfg may declare.  The number is far
// above the limit of 64 selectors, and still so small that sums of such numbers fit an int.
constexpr int kCountMax = 10'000;

struct KeywordName {
  const char* word;
  StubKeyword keyword;
};

constexpr KeywordName kKeywords[] = {
    {"ObjectName", StubKeyword::kObjectName},
    {"NumOfOSubject", StubKeyword::kNumOfSubject},
    {"NumOfSubject", StubKeyword::kNumOfSubject},
    {"NumOfOObserver", StubKeyword::kNumOfObserver},
    {"NumOfObserver", StubKeyword::kNumOfObserver},
    {"Service", StubKeyword::kService},
    {"Extra", StubKeyword::kExtra},
};

bool IsNameCharacter(char c) { return IsLetter(c) || IsDigit(c) || c == '_'; }

// Returns the C++ name at the start of `text`, or "" if its first character cannot be part of a
// name.
std::string_view NameAtStart(std::string_view text) {
  const auto end = std::find_if_not(text.begin(), text.end(), IsNameCharacter);
  return text.substr(0, static_cast<size_t>(end - text.begin()));
}

// A part of a line of stub.cfg, and the column at which it begins.
struct Piece {
  std::string_view text;
  int column = 1;

  void Skip(size_t count) {
    text.remove_prefix(count);
    column += static_cast<int>(count);
  }
  void SkipBlanks() {
    while (!text.empty() && IsBlank(text.front())) Skip(1);
  }
  void TrimEnd() {
    while (!text.empty() && IsBlank(text.back())) text.remove_suffix(1);
  }
};

bool IsName(std::string_view text) {
  return !text.empty() && !IsDigit(text.front()) &&
         std::all_of(text.begin(), text.end(), IsNameCharacter);
}

bool StartsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

// Adds errors and warnings about one line of stub.cfg to the list of diagnostics.
class Reporter {
 public:
  Reporter(const FilePosition& place, std::vector<Diagnostic>* diagnostics)
      : place_(place), diagnostics_(diagnostics) {}

  void Error(int column, std::string message) {
    diagnostics_->push_back(ErrorAt(AtColumn(place_, column), std::move(message)));
  }
  void Warning(int column, std::string message) {
    diagnostics_->push_back(WarningAt(AtColumn(place_, column), std::move(message)));
  }

 private:
  const FilePosition& place_;
  std::vector<Diagnostic>* const diagnostics_;
};

const KeywordName* FindKeyword(std::string_view word) {
  for (const KeywordName& entry : kKeywords) {
    if (word == entry.word) return &entry;
  }
  return nullptr;
}

// Warns about an ignored line of stub.cfg that the author probably did not mean as a comment.
// `rest` is the text of the line from its first word, `word`, on.
void WarnOfNearMiss(const Piece& rest, std::string_view word, Reporter* reporter) {
  if (FindKeyword(word) != nullptr) {
    // Takes a line that begins with "Service" or "Extra" for a comment if it has neither quote nor
    // bracket.  Both words may begin an English sentence, but a real Service line has a quote and a
    // real Extra line has a bracket.
    const bool is_prose = (word == "Service" || word == "Extra") &&
                          rest.text.find_first_of("\"(") == std::string_view::npos;
    if (is_prose) return;
    reporter->Warning(rest.column, fmt::format("line ignored: no ':' after '{0}'; write '{0} : ...'"
                                               ", or '//' before a comment",
                                               word));
    return;
  }
  Piece after = rest;
  after.Skip(word.size());
  after.SkipBlanks();
  if (!StartsWith(after.text, ":")) return;
  std::vector<std::string> words;
  for (const KeywordName& entry : kKeywords) words.push_back(entry.word);
  const std::string remedy = DidYouMean(word, words);
  if (remedy.empty()) return;
  reporter->Warning(rest.column, fmt::format("line ignored: no keyword '{}'{}", word, remedy));
}

// Takes a service name in quotes, such as "A.b.C.S", from the start of `rest`.  If there is no such
// name, warns and returns nullopt.
std::optional<ServiceName> ParseQuotedName(Piece* rest, Reporter* reporter) {
  const char* const form = "Service : \"Object.Service.Data.S\", Function(), Function()";
  if (!StartsWith(rest->text, "\"")) {
    reporter->Warning(rest->column,
                      fmt::format("line ignored: service name without quotes; write {}", form));
    return std::nullopt;
  }
  const size_t end = rest->text.find('"', 1);
  if (end == std::string_view::npos) {
    reporter->Warning(rest->column,
                      fmt::format("line ignored: closing quote is missing; write {}", form));
    return std::nullopt;
  }
  const std::string_view text = rest->text.substr(1, end - 1);
  ServiceNameFault fault;
  std::optional<ServiceName> name = ParseServiceName(text, &fault);
  const int column = rest->column + 1;
  if (!name) {
    reporter->Warning(column + fault.offset, "line ignored: " + fault.message);
    return std::nullopt;
  }
  rest->Skip(end + 1);
  const size_t blank = text.find_first_of(" \t");
  if (blank != std::string_view::npos) {
    reporter->Error(column + static_cast<int>(blank),
                    "blank in a service name; no line of CONNECT.CFG could name it");
  } else if (text.size() > static_cast<size_t>(kServiceNameBytesMax)) {
    reporter->Error(column, fmt::format("service name of {} characters, the limit is {}",
                                        text.size(), kServiceNameBytesMax));
  }
  // Allows only characters of C++ names in the second part of a service name.  The generated def.h
  // names a constant after this part: sbjMove for the part Move.
  const bool makes_names =
      std::all_of(name->short_name.begin(), name->short_name.end(), IsNameCharacter);
  if (!makes_names) {
    const char* const prefix = name->is_subject() ? "sbj" : "obs";
    reporter->Error(column + static_cast<int>(name->object.size()) + 1,
                    fmt::format("'{0}' cannot be part of the C++ name {1}{0}; use letters, digits "
                                "and '_' only",
                                name->short_name, prefix));
  }
  return name;
}

// Returns advice for the end of an error message about `rest`, the text in a line of stub.cfg where
// nothing more is allowed.
const char* RemedyForRest(std::string_view rest) {
  const bool is_comment = StartsWith(rest, "//") || StartsWith(rest, "#") || StartsWith(rest, "/*");
  return is_comment ? "; a comment needs a line of its own" : "; remove it";
}

struct Fault {
  std::string message;  // "" if there is no fault
  size_t offset = 0;
};

// Finds the fault in `rest`, the text after the function name `name` in a line of stub.cfg.
// The text should be "()".
Fault FindBracketFault(std::string_view rest, std::string_view name) {
  if (rest == "()") return {};
  if (rest.empty()) {
    if (EqualsIgnoringCase(name, "null")) {
      return {fmt::format("'{}' has no '()'; write null in lower case for no function", name)};
    }
    return {fmt::format("function '{0}' has no '()'; write {0}(), or null for no function{1}", name,
                        DidYouMean(name, {"null"}))};
  }
  if (StartsWith(rest, "()")) {
    const size_t offset = rest.find_first_not_of(" \t", 2);
    const std::string_view after = rest.substr(offset);
    return {fmt::format("'{}' after {}(){}", after, name, RemedyForRest(after)), offset};
  }
  if (StartsWith(rest, "(")) {
    return {fmt::format("write {}() with nothing between the brackets, not even a blank", name)};
  }
  if (name == "null") return {fmt::format("'{}' after null{}", rest, RemedyForRest(rest))};
  return {fmt::format("'{1}' after '{0}'; write {0}(), or null for no function", name, rest)};
}

// Parses a function in a Service line of stub.cfg, "Name()" or "null".  Returns the name, or "" for
// null and after an error.
std::string ParseFunction(Piece piece, Reporter* reporter) {
  piece.SkipBlanks();
  piece.TrimEnd();
  if (piece.text == "null") return "";
  const std::string_view name = NameAtStart(piece.text);
  if (!IsName(name)) {
    reporter->Error(
        piece.column,
        piece.text.empty()
            ? "function is missing; write Name(), or null for no function"
            : fmt::format("'{}' is not a function; write Name(), or null for none", piece.text));
    return "";
  }
  Piece rest = piece;
  rest.Skip(name.size());
  rest.SkipBlanks();
  const Fault fault = FindBracketFault(rest.text, name);
  if (fault.message.empty()) return std::string(name);
  const int column = rest.column + static_cast<int>(fault.offset);
  reporter->Error(rest.text.empty() ? piece.column : column, fault.message);
  return "";
}

// Parses the end of a Service line of stub.cfg, such as ", F(), G()", into `service`: the two
// functions after the name of the service.
void ParseFunctions(Piece rest, StubService* service, Reporter* reporter) {
  rest.SkipBlanks();
  if (!StartsWith(rest.text, ",")) {
    reporter->Error(rest.column,
                    "comma and two functions must follow the name; write null for no function");
    return;
  }
  rest.Skip(1);
  const size_t comma = rest.text.find(',');
  service->connect_function = ParseFunction({rest.text.substr(0, comma), rest.column}, reporter);
  if (comma == std::string_view::npos) {
    const char* const kind = service->name.is_subject() ? "ready" : "notify";
    reporter->Error(
        rest.column + static_cast<int>(rest.text.size()),
        fmt::format("second function ({}) is missing; write ', Name()' or ', null'", kind));
    return;
  }
  rest.Skip(comma + 1);
  const size_t third = rest.text.find(',');
  service->data_function = ParseFunction({rest.text.substr(0, third), rest.column}, reporter);
  if (third != std::string_view::npos) {
    reporter->Error(rest.column + static_cast<int>(third),
                    "more than two functions; a service has two");
  }
}

}  // namespace

std::optional<StubLine> RecognizeStubLine(const FilePosition& line,
                                          std::vector<Diagnostic>* diagnostics) {
  Reporter reporter(line, diagnostics);
  Piece rest{line.text, 1};
  rest.SkipBlanks();
  const std::string_view word = NameAtStart(rest.text);
  const KeywordName* const keyword = FindKeyword(word);
  Piece after = rest;
  after.Skip(word.size());
  after.SkipBlanks();
  if (keyword == nullptr || !StartsWith(after.text, ":")) {
    WarnOfNearMiss(rest, word, &reporter);
    return std::nullopt;
  }
  after.Skip(1);
  after.SkipBlanks();
  after.TrimEnd();
  return StubLine{keyword->keyword, std::string(word), AtColumn(line, after.column),
                  std::string(after.text)};
}

std::string ParseObjectName(const StubLine& line, std::vector<Diagnostic>* diagnostics) {
  const std::vector<Word> words = SplitWords(line.value);
  if (words.empty()) {
    diagnostics->push_back(
        ErrorAt(line.place, "ObjectName without a name; write the object's C++ class"));
    return "";
  }
  if (!IsName(words[0].text)) {
    diagnostics->push_back(ErrorAt(
        line.place, fmt::format("'{}' is not the name of a C++ class; use letters, digits and '_'",
                                words[0].text)));
    return "";
  }
  return words[0].text;
}

std::optional<int> ParseCount(const StubLine& line, std::vector<Diagnostic>* diagnostics) {
  int count = 0;
  const char* const end = line.value.data() + line.value.size();
  const std::errc status = std::from_chars(line.value.data(), end, count).ec;
  if (status == std::errc() && count >= 0 && count <= kCountMax) return count;
  diagnostics->push_back(
      ErrorAt(line.place, fmt::format("{} needs a number of services, such as 1", line.word)));
  return std::nullopt;
}

std::optional<StubService> ParseService(const StubLine& line,
                                        std::vector<Diagnostic>* diagnostics) {
  Reporter reporter(line.place, diagnostics);
  Piece rest{line.value, line.place.column};
  const int name_column = rest.column + 1;
  const std::optional<ServiceName> name = ParseQuotedName(&rest, &reporter);
  if (!name) return std::nullopt;
  StubService service{*name, "", "", AtColumn(line.place, name_column)};
  ParseFunctions(rest, &service, &reporter);
  return service;
}

std::optional<StubExtra> ParseExtra(const StubLine& line, std::vector<Diagnostic>* diagnostics) {
  const std::vector<Word> words = SplitWords(line.value);
  std::string_view word = words.empty() ? std::string_view() : words[0].text;
  const std::string_view name = NameAtStart(word);
  if (IsName(name) && word.substr(name.size()) == "()") {
    return StubExtra{std::string(name), line.place};
  }
  std::string message = "Extra without a function; write Extra : Name()";
  if (IsName(name)) {
    message =
        fmt::format("function '{0}' must be followed by '()' at once; write Extra : {0}()", name);
  } else if (!word.empty()) {
    message = fmt::format("'{}' is not a function; write Extra : Name()", word);
  }
  diagnostics->push_back(ErrorAt(line.place, std::move(message)));
  return std::nullopt;
}

}  // namespace openr_host
