#include "kit/macro_text.h"

#include <algorithm>
#include <cctype>

#include "kit/source_text.h"

namespace openr_host {
namespace {

// Limit for the size in bytes of a text with expanded macros, because nested macros may double the
// text many times.
constexpr size_t kExpandedMax = 4 << 20;

bool IsNumber(std::string_view word) {
  // Limits the length of the number, because std::stoi() in NumberOf() throws if a number is too
  // large.
  return !word.empty() && word.size() < 8 &&
         std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string Trimmed(std::string_view text) {
  const size_t begin = text.find_first_not_of(" \t\r\n\\");
  if (begin == kNone) return "";
  return std::string(text.substr(begin, text.find_last_not_of(" \t\r\n\\") + 1 - begin));
}

// Returns `body`, the text of a macro, without outer brackets: "64" for "(64)".
std::string_view WithoutBrackets(std::string_view body) {
  while (body.size() > 2 && body.front() == '(' && body.back() == ')')
    body = body.substr(1, body.size() - 2);
  return body;
}

// Returns the end of the line that begins at `at`, as the preprocessor sees it: if the line ends in
// a backslash, the next line is a part of it.
size_t EndOfDirective(std::string_view code, size_t at) {
  for (size_t i = at; i < code.size(); ++i) {
    if (code[i] == '\n' && (i == 0 || code[i - 1] != '\\')) return i;
  }
  return code.size();
}

struct Directive {
  size_t begin = 0;  // position of the character #
  size_t end = 0;
  std::string_view word;  // name of the directive, such as "define"
  size_t rest = 0;        // position after the word
};

// Returns the preprocessor directives, such as #define, of a text without comments.
std::vector<Directive> DirectivesOf(std::string_view code) {
  std::vector<Directive> found;
  for (size_t line = 0; line < code.size();) {
    const size_t end = EndOfDirective(code, line);
    const size_t first = code.find_first_not_of(" \t", line);
    if (first != kNone && first < end && code[first] == '#') {
      const size_t word_at = std::min(code.find_first_not_of(" \t", first + 1), end);
      const std::string_view word = WordAt(code, word_at);
      found.push_back({first, end, word, word_at + word.size()});
    }
    line = end + 1;
  }
  return found;
}

// Returns the text with all directives, and the parts between "#if 0" and its #else or #endif,
// replaced by blanks.
std::string WithoutDirectives(std::string code) {
  const auto blank = [&code](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (code[i] != '\n') code[i] = ' ';
    }
  };
  int depth = 0;  // number of open conditions, counted from "#if 0"; 0: outside
  size_t dead = 0;
  // Finds the directives in a copy of the text, because the loop overwrites parts of `code` with
  // blanks while it still reads the directives.
  const std::string text = code;
  for (const Directive& directive : DirectivesOf(text)) {
    const bool opens = directive.word.starts_with("if");
    const std::string rest = Trimmed(text.substr(directive.rest, directive.end - directive.rest));
    if (depth > 0) {
      if (opens) ++depth;
      // An #else or #elif that belongs to "#if 0" itself also ends the part that is not compiled,
      // because the code after it may be compiled.
      if (directive.word == "endif" || (directive.word.starts_with("el") && depth == 1)) --depth;
      if (depth == 0) blank(dead, directive.begin);
    } else if (opens && rest == "0") {
      depth = 1;
      dead = directive.begin;
    }
    blank(directive.begin, directive.end);
  }
  if (depth > 0) blank(dead, code.size());
  return code;
}

// Returns the parts of a list in brackets: "a" and "b" of "(a, b)".  `open` and `close` are the
// positions of the brackets.
std::vector<std::string> PartsOf(std::string_view text, size_t open, size_t close) {
  std::vector<std::string> parts;
  int depth = 0;
  size_t from = open + 1;
  for (size_t i = open + 1; i <= close; ++i) {
    if ((text[i] == ',' && depth == 0) || i == close) {
      parts.push_back(Trimmed(text.substr(from, i - from)));
      from = i + 1;
    } else if (text[i] == '(') {
      ++depth;
    } else if (text[i] == ')') {
      --depth;
    }
  }
  return parts;
}

// Returns `body`, the text of a macro, with the names in `parameters` replaced by `values`.
std::string Filled(std::string_view body, const std::vector<std::string>& parameters,
                   const std::vector<std::string>& values) {
  std::string filled;
  for (size_t at = 0; at < body.size();) {
    const std::string_view word = WordAt(body, at);
    const auto found = std::find(parameters.begin(), parameters.end(), word);
    const auto index = static_cast<size_t>(found - parameters.begin());
    if (word.empty()) {
      filled += body[at];
    } else {
      filled += found == parameters.end() || index >= values.size() ? word : values[index];
    }
    at += std::max<size_t>(word.size(), 1);
  }
  return filled;
}

}  // namespace

void MacroTable::Read(const std::string& source) {
  const std::string code = WithoutComments(source);
  for (const Directive& directive : DirectivesOf(code)) {
    if (directive.word != "define") continue;
    const size_t at = std::min(code.find_first_not_of(" \t", directive.rest), directive.end);
    const std::string name(WordAt(code, at));
    if (name.empty()) continue;
    Macro macro;
    size_t body = at + name.size();
    if (body < directive.end && code[body] == '(') {
      const size_t close = ClosingOf(code, body);
      if (close == kNone || close >= directive.end) continue;
      macro.parameters = PartsOf(code, body, close);
      body = close + 1;
    }
    macro.body = Trimmed(code.substr(body, directive.end - body));
    std::replace(macro.body.begin(), macro.body.end(), '\\', ' ');
    macro.written = Trimmed(source.substr(body, directive.end - body));
    macros_[name] = macro;
  }
}

int MacroTable::NumberOf(std::string_view word) const {
  const auto found = macros_.find(word);
  const std::string_view text = found == macros_.end() || found->second.parameters
                                    ? word
                                    : WithoutBrackets(found->second.body);
  return IsNumber(text) ? std::stoi(std::string(text)) : -1;
}

std::string MacroTable::WrittenAs(const std::string& word) const {
  const auto found = macros_.find(word);
  return found == macros_.end() ? "" : found->second.written;
}

ExpandedText MacroTable::Expand(const std::string& source) const {
  const std::string code = WithoutDirectives(WithoutComments(source));
  ExpandedText result;
  Put(code, kNone, {}, &result);
  return result;
}

// Expands the use of a macro at the position `at`: appends the expansion to `result`, and returns
// the position after the use.  Returns `at` if no macro is used at this position.  All appended
// characters get the origin `origin` (ExpandedText::origins).  Does not expand the macros in
// `hidden`, because `text` is a part of their own expansion: a macro that contains its own name
// would be expanded without end.
size_t MacroTable::PutMacro(std::string_view text, size_t at, size_t origin, const Names& hidden,
                            ExpandedText* result) const {
  const std::string_view word = WordAt(text, at);
  const auto found = word.empty() ? macros_.end() : macros_.find(word);
  if (found == macros_.end() || hidden.contains(found->first) || NumberOf(word) >= 0) return at;
  const auto& [name, macro] = *found;
  Names inner = hidden;
  inner.insert(name);
  if (!macro.parameters) {
    Put(macro.body, origin, inner, result);
    return at + word.size();
  }
  const size_t open = NextOf(text, at + word.size());
  const size_t close = open != kNone && text[open] == '(' ? ClosingOf(text, open) : kNone;
  if (close == kNone) return at;
  Put(Filled(macro.body, *macro.parameters, PartsOf(text, open, close)), origin, inner, result);
  return close + 1;
}

// Expands the macros in `text` and appends the resulting characters to `result`, each with its
// origin, an offset in the source (ExpandedText::origins).  If `text` is the source itself, `fixed`
// is kNone, and the origin of a character is its offset in `text`.  If `text` comes from a macro,
// `fixed` is the offset of the macro's use, and this is the origin of all characters.  Does not
// expand the macros in `hidden`, because `text` is a part of their own expansion: a macro that
// contains its own name would be expanded without end.
void MacroTable::Put(std::string_view text, size_t fixed, const Names& hidden,
                     ExpandedText* result) const {
  for (size_t at = 0; at < text.size() && result->text.size() < kExpandedMax;) {
    const size_t after = PutMacro(text, at, fixed == kNone ? at : fixed, hidden, result);
    const size_t end = after > at ? at : at + std::max<size_t>(WordAt(text, at).size(), 1);
    for (size_t i = at; i < end; ++i) {
      result->text += text[i];
      result->origins.push_back(fixed == kNone ? i : fixed);
    }
    at = std::max(after, end);
  }
}

}  // namespace openr_host
