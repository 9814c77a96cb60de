// Writes the fields of a line of comma-separated values.
#pragma once

#include <string>

namespace openr_host {

// Returns `text` as a field of a line of comma-separated values: in quotes if it has a comma, a
// quote or a newline.
inline std::string CsvField(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace openr_host
