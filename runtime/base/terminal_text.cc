#include "runtime/base/terminal_text.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace openr_host {

std::string TerminalText(std::string text) {
  for (size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    const bool is_good = byte == '\t' || byte == '\n' || (byte == '\r' && next == '\n');
    if ((byte < 0x20 && !is_good) || byte == 0x7f) text[i] = '?';
    if (byte == 0xc2 && next >= 0x80 && next <= 0x9f) text[i] = text[i + 1] = '?';
  }
  return text;
}

std::string TerminalLine(std::string text) {
  text = TerminalText(std::move(text));
  std::replace(text.begin(), text.end(), '\n', '?');
  std::replace(text.begin(), text.end(), '\r', '?');
  return text;
}

}  // namespace openr_host
