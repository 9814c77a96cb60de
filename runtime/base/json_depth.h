// IsJsonTooDeep(), which finds JSON that is nested too deeply.
#pragma once

#include <cstddef>
#include <string_view>

namespace openr_host {

// The number of levels to which lists and objects may be nested in JSON of a file or of another
// program.  The JSON that openr uses has less than ten levels.
inline constexpr size_t kJsonDepthMax = 100;

// Returns whether lists and objects in the text `json` are nested more than kJsonDepthMax levels
// deep.  Code that parses JSON of a file or of another program must call this function first,
// because the JSON library copies and writes JSON by recursion: JSON with tens of thousands of
// levels would overflow the stack.
constexpr bool IsJsonTooDeep(std::string_view json) {
  size_t depth = 0;
  bool is_in_text = false;
  for (size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '"') {
      is_in_text = !is_in_text;
    } else if (is_in_text) {
      // Skips the character after a backslash, because a quote there does not end the text.
      if (c == '\\') ++i;
    } else if (c == '[' || c == '{') {
      if (++depth > kJsonDepthMax) return true;
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return false;
}

}  // namespace openr_host
