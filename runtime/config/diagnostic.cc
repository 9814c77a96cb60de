#include "runtime/config/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

// Returns blanks and tabs that take as much width on a terminal as the first `column` - 1 bytes of
// `text`.  A caret after them is under the byte at `column`.
std::string Indent(const std::string& text, int column) {
  std::string indent;
  for (int i = 0; i + 1 < column; ++i) {
    const char c = static_cast<size_t>(i) < text.size() ? text[i] : ' ';
    const bool continues_utf8 = (static_cast<unsigned char>(c) & 0xc0) == 0x80;
    if (continues_utf8) continue;
    indent += c == '\t' ? '\t' : ' ';
  }
  return indent;
}

std::string RenderAs(const Diagnostic& d, const char* kind) {
  const std::string file = TerminalLine(d.file), message = TerminalLine(d.message);
  if (d.line == 0) return fmt::format("{}: {}{}", file, kind, message);
  std::string result =
      fmt::format("{}:{}: {}{}\n{}", file, d.line, kind, message, TerminalLine(d.text));
  if (d.column > 0) result += fmt::format("\n{}^", Indent(d.text, d.column));
  return result;
}

Diagnostic At(const FilePosition& place, Severity severity, std::string message) {
  return Diagnostic{severity, place.file, place.line, place.column, std::move(message), place.text};
}

}  // namespace

FilePosition AtColumn(FilePosition place, int column) {
  place.column = column;
  return place;
}

Diagnostic ErrorAt(const FilePosition& place, std::string message) {
  return At(place, Severity::kError, std::move(message));
}

Diagnostic WarningAt(const FilePosition& place, std::string message) {
  return At(place, Severity::kWarning, std::move(message));
}

bool HasErrors(const std::vector<Diagnostic>& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::kError; });
}

std::string Render(const Diagnostic& d) {
  if (d.severity == Severity::kNote) return RenderAs(d, "note: ");
  return RenderAs(d, d.severity == Severity::kWarning ? "warning: " : "");
}

std::string RenderWithoutKind(const Diagnostic& d) { return RenderAs(d, ""); }

std::string Render(const std::vector<Diagnostic>& diagnostics) {
  std::string result;
  for (const Diagnostic& diagnostic : diagnostics) result += Render(diagnostic) + "\n";
  return result;
}

}  // namespace openr_host
