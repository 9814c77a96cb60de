#include "cli/print_plain.h"

#include "runtime/base/terminal_text.h"

namespace openr_host {

void PrintPlainText(std::FILE* stream, std::string text) {
  fmt::print(stream, "{}", TerminalText(std::move(text)));
}

}  // namespace openr_host
