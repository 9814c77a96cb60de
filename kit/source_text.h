// Reading C++ as text: where words and brackets are, with comments and strings out of the way.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// `text` with comments, strings and characters replaced by blanks; of the same length.
std::string WithoutComments(std::string_view text);

// A string in quotes.
struct StringLiteral {
  size_t at = 0;     // of the opening quote
  std::string text;  // between the quotes, as it is written
};

// The strings of `text` that stand in no comment.
std::vector<StringLiteral> StringLiteralsIn(std::string_view text);

// The position of a line and a column, both from 1; npos when the text has no such place.
size_t OffsetOf(std::string_view text, int line, int column);

// A position that there is not.
inline constexpr size_t kNone = std::string_view::npos;

// The next position from `at` on (before `at`) that is not a blank or the end of a line, or kNone.
size_t NextOf(std::string_view text, size_t at);
size_t PreviousOf(std::string_view text, size_t at);

bool IsWordCharacter(char c);

// Whether the word `word` begins at `at`.
bool HasWordAt(std::string_view text, size_t at, std::string_view word);

// The word that begins at `at`; "" if none does.
std::string_view WordAt(std::string_view text, size_t at);

// The position of the bracket that closes the one at `open`; npos if there is none.
size_t ClosingOf(std::string_view text, size_t open);

}  // namespace openr_host
