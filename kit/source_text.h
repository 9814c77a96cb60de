// Finds words, brackets and string literals in the text of a C or C++ source.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// Returns `text` with blanks in place of comments, strings and character literals.  Line ends stay,
// so that positions and line numbers are those of `text`.
std::string WithoutComments(std::string_view text);

// Returns `code`, a text without comments, with blanks in place of everything between #if and
// #endif, so that checks do not report calls in these lines.  In programs that also run on a PC,
// such lines may be compiled only for the PC.
std::string WithoutConditionalCode(std::string code);

// A string literal of a source.
struct StringLiteral {
  size_t at = 0;     // position of the opening quote
  std::string text;  // text between the quotes, as written
};

// Returns the string literals of `text` outside of comments.
std::vector<StringLiteral> StringLiteralsIn(std::string_view text);

// Returns the position of a line and a column, both from 1; npos if the text has no such place.
size_t OffsetOf(std::string_view text, int line, int column);

// The value that NextOf(), PreviousOf() and ClosingOf() return if they find no position.
inline constexpr size_t kNone = std::string_view::npos;

// A regular expression for a part of a statement.  The length of the part is limited, because
// std::regex_search() is recursive: it calls itself for each character that a repetition matches,
// so a long part could overflow the stack.
inline const std::string kPartOfStatement = "[^;]{0,400}";

// Returns the position of the first character from `at` on that is neither a blank nor a line end;
// kNone if there is no such character.
size_t NextOf(std::string_view text, size_t at);

// Returns the position of the last character before `at` that is neither a blank nor a line end;
// kNone if there is no such character.
size_t PreviousOf(std::string_view text, size_t at);

bool IsWordCharacter(char c);

// Returns whether the whole word `word` begins at `at`.
bool HasWordAt(std::string_view text, size_t at, std::string_view word);

// Returns whether the whole word `word` occurs in the text.
bool HasWord(std::string_view text, std::string_view word);

// Returns the word that begins at `at`; "" if no word begins at `at`.
std::string_view WordAt(std::string_view text, size_t at);

// Returns the position of the bracket that closes the bracket at `open`; npos if there is no such
// bracket.
size_t ClosingOf(std::string_view text, size_t open);

}  // namespace openr_host
