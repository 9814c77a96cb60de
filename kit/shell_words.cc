#include "kit/shell_words.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace openr_host {

std::string ShellWord(const std::string& text) {
  const auto is_plain = [](char c) {
    // Bytes of characters outside of ASCII need no quotes, because they mean nothing to the shell.
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0 ||
           std::string_view("/._+-=:,@%").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::vector<std::string> SplitShellWords(const std::string& command) {
  std::vector<std::string> words;
  bool is_open = false;  // true: a word has begun, even if it has no characters yet
  char quote = 0;
  for (size_t i = 0; i < command.size(); ++i) {
    const char c = command[i];
    const bool is_blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (quote == 0 && is_blank) {
      is_open = false;
      continue;
    }
    if (!is_open) words.emplace_back();
    is_open = true;
    if (c == '\\' && quote != '\'' && i + 1 < command.size()) {
      words.back() += command[++i];
    } else if (c == quote) {
      quote = 0;
    } else if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
    } else {
      words.back() += c;
    }
  }
  return words;
}

}  // namespace openr_host
