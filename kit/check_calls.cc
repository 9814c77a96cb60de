#include "kit/check_calls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <regex>
#include <string_view>

#include "kit/source_place.h"
#include "kit/source_text.h"
#include "runtime/base/spelling.h"

namespace openr_host {
namespace {

// Returns the word before the position `at`, with only blanks between them; "" if there is no such
// word.
std::string_view WordBefore(std::string_view code, size_t at) {
  const size_t last = PreviousOf(code, at);
  if (last == kNone || !IsWordCharacter(code[last])) return "";
  size_t begin = last;
  while (begin > 0 && IsWordCharacter(code[begin - 1])) --begin;
  return code.substr(begin, last + 1 - begin);
}

// Returns whether `word`, such as "return", can stand before an expression.  If so, it is not a
// type, and the word after it is used and not declared.
bool IsBeforeExpression(std::string_view word) {
  constexpr std::string_view kWords[] = {"return", "case", "else", "do", "throw"};
  return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
}

std::string_view LineAround(std::string_view text, size_t at) {
  const size_t newline = text.rfind('\n', at);
  const size_t begin = newline == kNone ? 0 : newline + 1;
  return text.substr(begin, std::min(text.find('\n', at), text.size()) - begin);
}

// Returns whether `code` may define the constant or variable `word`.  Signs of a definition are:
// before the word a type or, as in an enum, a comma or '{'; after the word '='; in the line of the
// word a directive such as #define.
bool MayDefine(const std::string& code, const std::string& word) {
  for (size_t at = code.find(word); at != kNone; at = code.find(word, at + 1)) {
    if (!HasWordAt(code, at, word)) continue;
    if (LineAround(code, at).find("#") != kNone) return true;
    const std::string_view before = WordBefore(code, at);
    if (!before.empty() && !IsBeforeExpression(before)) return true;
    const size_t last = PreviousOf(code, at);
    if (last != kNone && std::string_view(",{*&").find(code[last]) != kNone) return true;
    const size_t next = NextOf(code, at + word.size());
    if (next != kNone && code[next] == '=' && code.substr(next, 2) != "==") return true;
  }
  return false;
}

// Returns the names of the indices that stubgen2 makes for `services`, such as "sbjMove".
std::vector<std::string> IndicesOf(const char* prefix, const std::vector<StubService>& services) {
  std::vector<std::string> names;
  for (const StubService& service : services) names.push_back(prefix + service.name.short_name);
  return names;
}

// Returns whether `code` defines a macro `name`, or declares a function or variable `name`.  A name
// counts as declared if one of these stands before it: a type, the '*' or '&' of a type, "Class::",
// or a list of other declared names with a comma.
bool HasOwn(const std::string& code, const std::string& name) {
  const std::regex macro("#[ \t]*define[ \t]+" + name + "\\b");
  if (std::regex_search(code, macro)) return true;
  for (size_t at = code.find(name); at != kNone; at = code.find(name, at + 1)) {
    if (!HasWordAt(code, at, name)) continue;
    const std::string_view before = WordBefore(code, at);
    if (!before.empty() && !IsBeforeExpression(before)) return true;
    const size_t last = PreviousOf(code, at);
    if (last == kNone || last == 0) continue;
    if (code[last] == '*' || code[last] == '&') return true;
    // Counts the name as declared if it ends a list of variables ("int i, name;"), or if it follows
    // the arguments of a template ("vector<int> name;").
    const size_t next = NextOf(code, at + name.size());
    if ((code[last] == ',' || code[last] == '>') && next != kNone &&
        std::string_view(";,[=").find(code[next]) != std::string_view::npos)
      return true;
    if (code.compare(last - 1, 2, "::") != 0) continue;
    // Counts "Class::name" as a declaration of the program, but not "std::name", because
    // std::time() is the function time() of the C library.
    const std::string_view space = WordBefore(code, last - 1);
    if (!space.empty() && space != "std") return true;
  }
  return false;
}

// Returns whether the call at `at` is a call of a member function, such as clock.time(0).
bool IsMemberCall(std::string_view code, size_t at) {
  const size_t last = PreviousOf(code, at);
  return last != kNone && (code[last] == '.' || code.substr(last - (last > 0), 2) == "->");
}

// Returns whether there is a comma between the bracket at `open` and the bracket that closes it.
// Commas in inner brackets do not count.
bool HasComma(std::string_view code, size_t open) {
  const size_t close = ClosingOf(code, open);
  for (size_t at = open + 1; close != kNone && at < close; ++at) {
    if (code[at] == ',') return true;
    if (code[at] == '(' || code[at] == '[' || code[at] == '{') at = ClosingOf(code, at);
  }
  return false;
}

// A clock of the C library that does not work on the robot.
struct Clock {
  const char* name;
  const char* arguments;  // regular expression for the arguments of a call
  // The check warns of this clock only if the source contains this word; "": the check always
  // warns.
  const char* word;
  const char* why;
};

constexpr Clock kClocks[] = {
    {"gettimeofday", "[^;{}]{1,80}", "tv_usec",
     "on the robot the part below the second is always the same (field-notes.md 12.1); here it is "
     "virtual time"},
    {"time", "[ \t]*(?:NULL|0|&[ \t]*\\w+)[ \t]*\\)", "",
     "the robot has no such clock (core.md 8.1); here it is virtual time"},
    {"clock", "[ \t]*(?:void)?[ \t]*\\)", "",
     "the robot has no such clock (core.md 8.1); here it is virtual time"},
};

class CallCheck {
 public:
  CallCheck(const SourceOfObject& source, const std::string& all_code, Remarks* remarks)
      : source_(source),
        code_(WithoutConditionalCode(WithoutComments(source.text))),
        all_code_(all_code),
        remarks_(remarks) {}

  void Run() {
    CheckBrackets();
    for (const Clock& clock : kClocks) CheckClock(clock);
    CheckFreeMemory();
  }

 private:
  void Warn(size_t at, const std::string& cause, std::string text) {
    remarks_->AddConsequence(Remark::Kind::kWarning, PlaceAt(source_.file, source_.text, at), cause,
                             std::move(text));
  }

  // Finds calls such as OSYSPRINT("text"), which lack the second pair of brackets of
  // OSYSPRINT(("text")).  The compiler complains about the code to which the macro expands, and
  // such a message does not lead a beginner to the missing brackets.  OSYSDEBUG and OSYSLOG can be
  // switched off.  Then the compiler accepts OSYSDEBUG("text"), but no call with a comma, so only
  // their calls with a comma count as mistakes.
  void CheckBrackets() {
    static const std::regex kMacro("\\b(OSYSPRINT|OSYSDEBUG|OSYSLOG[1-4])[ \t]*\\(");
    for (std::sregex_iterator it(code_.begin(), code_.end(), kMacro), end; it != end; ++it) {
      const std::string name = (*it)[1];
      const size_t at = static_cast<size_t>(it->position(0));
      const size_t open = at + static_cast<size_t>(it->length(0)) - 1;
      // Looks for the string after the bracket in the source itself, because code_ has blanks in
      // place of strings.
      const size_t first = NextOf(source_.text, open + 1);
      // Skips directives such as #define, because a program may define OSYSPRINT or OSYSLOG itself.
      if (first == kNone || LineAround(code_, at).find('#') != kNone) continue;
      const bool has_text =
          source_.text[first] == '"' || source_.text.compare(first, 7, "osyslog") == 0;
      if (!has_text || (name != "OSYSPRINT" && !HasComma(code_, open))) continue;
      if (HasOwn(all_code_, name)) continue;
      const char* const begin = name.starts_with("OSYSLOG") ? "osyslogERROR, " : "";
      Warn(at, "brackets of " + name,
           fmt::format("{0} is a macro that needs two pairs of brackets: {0}(({1}\"text %d\\n\", "
                       "number));",
                       name, begin));
    }
  }

  void CheckClock(const Clock& clock) {
    if (*clock.word != '\0' && !HasWord(code_, clock.word)) return;
    const std::regex call(std::string("\\b") + clock.name + "[ \t]*\\(" + clock.arguments);
    for (std::sregex_iterator it(code_.begin(), code_.end(), call), end; it != end; ++it) {
      const size_t at = static_cast<size_t>(it->position(0));
      if (IsMemberCall(code_, at) || HasOwn(all_code_, clock.name)) continue;
      // Does not warn of a call of a clock that seeds random numbers, because even a clock that
      // stands still can give the seed.
      if (IsSeed(at, at + static_cast<size_t>(it->length(0)))) continue;
      Warn(at, clock.name,
           fmt::format("{}(): {}; take GetSystemTime(), which has microseconds since the boot, or "
                       "OPENR::GetTime(), which has the date in seconds",
                       clock.name, clock.why));
    }
  }

  // Returns whether the value of a clock seeds random numbers.  The call of the clock begins at the
  // position `at` and ends at `end`.  Its value is a seed if the call stands in the brackets of
  // srand(), or if srand() gets a variable that has the value.
  bool IsSeed(size_t at, size_t end) const {
    const std::vector<std::string> names = NamesOfValue(at, end);
    static const std::regex kSeed("\\bsrand(?:om)?[ \t]*\\(");
    for (std::sregex_iterator it(code_.begin(), code_.end(), kSeed), last; it != last; ++it) {
      const size_t open = static_cast<size_t>(it->position(0) + it->length(0)) - 1;
      const size_t close = ClosingOf(code_, open);
      if (close == kNone) continue;
      if (open < at && at < close) return true;
      const std::string_view given = std::string_view(code_).substr(open, close - open);
      for (const std::string& name : names) {
        if (HasWord(given, name)) return true;
      }
    }
    return false;
  }

  // Returns the position of the first character of the assignment operator, such as "^=", that has
  // its '=' at `at`; 0 if this '=' belongs to a comparison, such as "<=", which assigns nothing.
  size_t BeginOfAssignment(size_t at) const {
    const char before = at > 0 ? code_[at - 1] : ' ';
    if (before == '=' || before == '!' || before == '<' || before == '>' || code_[at + 1] == '=')
      return 0;
    return std::string_view("+-*/%&|^").find(before) == std::string_view::npos ? at : at - 1;
  }

  // Returns the names of the variables that get the value of the call from `at` to `end`: "seed"
  // for "unsigned seed = time(0)" and "unsigned seed(time(0))", "now" for "time(&now)".
  std::vector<std::string> NamesOfValue(size_t at, size_t end) const {
    std::vector<std::string> names;
    const std::string_view code = code_;
    for (size_t i = at; i > 0 && code[i - 1] != ';' && code[i - 1] != '{' && code[i - 1] != '}';
         --i) {
      if (code[i - 1] == '(') names.emplace_back(WordBefore(code, i - 1));
      if (code[i - 1] == '=') names.emplace_back(WordBefore(code, BeginOfAssignment(i - 1)));
    }
    for (size_t i = code.find('&', at); i < end; i = code.find('&', i + 1)) {
      const size_t next = NextOf(code, i + 1);
      if (next != kNone) names.emplace_back(WordAt(code, next));
    }
    std::erase(names, "");
    return names;
  }

  // Warns of calls of AnalyzerGetSizeOfFreeMemory().  Our headers do not declare this function,
  // because no document gives its arguments.  Without this warning, the compiler would only say
  // that the function is not declared.
  void CheckFreeMemory() {
    constexpr std::string_view kName = "AnalyzerGetSizeOfFreeMemory";
    for (size_t at = code_.find(kName); at != kNone; at = code_.find(kName, at + 1)) {
      if (!HasWordAt(code_, at, kName)) continue;
      Warn(
          at, std::string(kName),
          fmt::format("{}() is not known here, and on the robot it misleads: the heap of an object "
                      "keeps the memory that free() gives back (field-notes.md 3.6); the report of "
                      "openr run --json has heap_bytes_max of each object",
                      kName));
    }
  }

  const SourceOfObject& source_;
  const std::string code_;
  const std::string& all_code_;
  Remarks* const remarks_;
};

}  // namespace

void CheckServiceIndices(const StubConfig& config, const std::vector<SourceOfObject>& sources,
                         const std::string& code, Remarks* remarks) {
  static const std::regex kIndex("\\b(?:subject|observer)[ \t]*\\[[ \t]*((sbj|obs)\\w+)[ \t]*\\]");
  for (const SourceOfObject& source : sources) {
    const std::string own = WithoutConditionalCode(WithoutComments(source.text));
    for (std::sregex_iterator it(own.begin(), own.end(), kIndex), end; it != end; ++it) {
      const std::string index = (*it)[1];
      const bool is_subject = (*it)[2] == "sbj";
      const std::vector<std::string> known =
          is_subject ? IndicesOf("sbj", config.subjects) : IndicesOf("obs", config.observers);
      if (std::find(known.begin(), known.end(), index) != known.end()) continue;
      if (MayDefine(code, index)) continue;
      remarks->AddConsequence(
          Remark::Kind::kWarning,
          PlaceAt(source.file, source.text, static_cast<size_t>(it->position(1))), "index " + index,
          fmt::format("{0} comes from no line of stub.cfg: stubgen2 makes it of the service {1} in "
                      "Service : \"{2}.{1}.TYPE.{3}\"{4}",
                      index, index.substr(3), config.object_name, is_subject ? "S" : "O",
                      DidYouMean(index, known)));
    }
  }
}

void CheckExtraEntries(const StubConfig& config, const std::vector<SourceOfObject>& sources,
                       const std::string& code, Remarks* remarks) {
  // Matches the arguments "myOID_, entryX", because Send() and OServiceEntry() take the object's
  // own id and then the selector.
  static const std::regex kSelector("\\bmyOID_[ \t\r\n]*,[ \t\r\n]*(entry(\\w+))[ \t\r\n]*[,)]");
  // Removes the uses of selectors from the text in which MayDefine() looks for definitions.  In
  // "myOID_, entryX", the name follows a comma, so MayDefine() would take it for a constant of an
  // enum.
  const std::string rest = std::regex_replace(code, kSelector, "");
  for (const SourceOfObject& source : sources) {
    const std::string own = WithoutConditionalCode(WithoutComments(source.text));
    for (std::sregex_iterator it(own.begin(), own.end(), kSelector), end; it != end; ++it) {
      const std::string index = (*it)[1], function = (*it)[2];
      const bool is_extra =
          std::any_of(config.extras.begin(), config.extras.end(),
                      [&](const StubExtra& extra) { return extra.function == function; });
      if (!is_extra || MayDefine(rest, index)) continue;
      remarks->AddConsequence(
          Remark::Kind::kWarning,
          PlaceAt(source.file, source.text, static_cast<size_t>(it->position(1))), "entry " + index,
          fmt::format("{0} is the place of {1}() in Extra_Entry[] and no selector (selector 0 is "
                      "DoInit, 1 is DoStart): write Extra_Entry[{0}]",
                      index, function));
    }
  }
}

void CheckCalls(const std::vector<SourceOfObject>& sources, const std::string& code,
                Remarks* remarks) {
  for (const SourceOfObject& source : sources) CallCheck(source, code, remarks).Run();
}

}  // namespace openr_host
