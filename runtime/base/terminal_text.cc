#include "runtime/base/terminal_text.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace openr_host {

std::string TerminalText(std::string text) {
  for (size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte < 0x20 && byte != '\t' && byte != '\n') || byte == 0x7f) text[i] = '?';
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if (byte == 0xc2 && next >= 0x80 && next <= 0x9f) text[i] = text[i + 1] = '?';
  }
  return text;
}

std::string TerminalLine(std::string text) {
  text = TerminalText(std::move(text));
  std::replace(text.begin(), text.end(), '\n', '?');
  return text;
}

}  // namespace openr_host
