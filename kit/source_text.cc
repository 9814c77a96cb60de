#include "kit/source_text.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace openr_host {
namespace {

// Returns the position after the comment that begins at `at`; `at` itself if no comment begins at
// `at`.
size_t EndOfComment(std::string_view text, size_t at) {
  if (text.substr(at, 2) == "//") return std::min(text.find('\n', at), text.size());
  if (text.substr(at, 2) != "/*") return at;
  const size_t end = text.find("*/", at + 2);
  return end == kNone ? text.size() : end + 2;
}

// Returns the position after the string or character literal that begins at `at`; `at` itself if no
// literal begins at `at`.  A literal without its closing quote ends with its line.
size_t EndOfString(std::string_view text, size_t at) {
  const char quote = text[at];
  if (quote != '"' && quote != '\'') return at;
  for (size_t i = at + 1; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
    } else if (text[i] == quote || text[i] == '\n') {
      return i + 1;
    }
  }
  return text.size();
}

// Returns the name of the directive in `line`, such as "if" for "# if X"; "" if `line` is no
// directive.
std::string_view DirectiveOf(std::string_view line) {
  const size_t sign = line.find_first_not_of(" \t");
  if (sign == kNone || line[sign] != '#') return "";
  const size_t word = line.find_first_not_of(" \t", sign + 1);
  return word == kNone ? "" : WordAt(line, word);
}

bool IsBlank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::string WithoutComments(std::string_view text) {
  std::string result(text);
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::max(EndOfComment(text, at), EndOfString(text, at));
    for (size_t i = at; i < end; ++i) {
      if (result[i] != '\n') result[i] = ' ';
    }
    at = std::max(end, at + 1);
  }
  return result;
}

// Uses no std::regex_search(), because it calls itself for each blank that it matches.  `code` has
// blanks in place of comments and strings (WithoutComments()), so a long comment or string would
// overflow the stack.
std::string WithoutConditionalCode(std::string code) {
  int depth = 0;
  for (size_t at = 0; at < code.size();) {
    const size_t end = std::min(code.find('\n', at), code.size());
    const std::string_view word = DirectiveOf(std::string_view(code).substr(at, end - at));
    if (word.starts_with("if")) ++depth;
    if (word.starts_with("endif")) --depth;
    if (depth > 0) {
      std::fill(code.begin() + static_cast<std::ptrdiff_t>(at),
                code.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    }
    at = end + 1;
  }
  return code;
}

std::vector<StringLiteral> StringLiteralsIn(std::string_view text) {
  std::vector<StringLiteral> literals;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::max(EndOfComment(text, at), EndOfString(text, at));
    if (text[at] == '"' && end >= at + 2)
      literals.push_back({at, std::string(text.substr(at + 1, end - at - 2))});
    at = std::max(end, at + 1);
  }
  return literals;
}

size_t OffsetOf(std::string_view text, int line, int column) {
  size_t start = 0;
  for (int i = 1; i < line; ++i) {
    start = text.find('\n', start);
    if (start == kNone) return kNone;
    ++start;
  }
  const size_t offset = start + static_cast<size_t>(column) - 1;
  return line < 1 || column < 1 || offset >= text.size() ? kNone : offset;
}

size_t NextOf(std::string_view text, size_t at) {
  while (at < text.size() && IsBlank(text[at])) ++at;
  return at < text.size() ? at : kNone;
}

size_t PreviousOf(std::string_view text, size_t at) {
  while (at > 0) {
    if (!IsBlank(text[--at])) return at;
  }
  return kNone;
}

bool IsWordCharacter(char c) {
  return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
}

std::string_view WordAt(std::string_view text, size_t at) {
  size_t end = at;
  while (end < text.size() && IsWordCharacter(text[end])) ++end;
  return text.substr(at, end - at);
}

bool HasWordAt(std::string_view text, size_t at, std::string_view word) {
  return (at == 0 || !IsWordCharacter(text[at - 1])) && WordAt(text, at) == word;
}

bool HasWord(std::string_view text, std::string_view word) {
  for (size_t at = text.find(word); at != kNone; at = text.find(word, at + 1)) {
    if (HasWordAt(text, at, word)) return true;
  }
  return false;
}

size_t ClosingOf(std::string_view text, size_t open) {
  int depth = 0;
  for (size_t i = open; i < text.size(); ++i) {
    if (text[i] == '(' || text[i] == '{' || text[i] == '[') ++depth;
    if (text[i] == ')' || text[i] == '}' || text[i] == ']') --depth;
    if (depth == 0) return i;
  }
  return kNone;
}

}  // namespace openr_host
