#include "kit/remarks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/colour.h"
#include "cli/json_text.h"
#include "kit/text_files.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr size_t kPlacesMax = 5;  // largest number of places in Remark::also_at

Remark::Kind KindOf(Severity severity) {
  if (severity == Severity::kNote) return Remark::Kind::kNote;
  return severity == Severity::kError ? Remark::Kind::kError : Remark::Kind::kWarning;
}

const char* WordOf(Remark::Kind kind) {
  switch (kind) {
    case Remark::Kind::kError:
      return "error";
    case Remark::Kind::kWarning:
      return "warning";
    default:
      return "note";
  }
}

// Returns `rendered`, the text of a remark (an error, a warning or a note), with the beginning of
// its first line in colour.  This beginning is the place and, except for errors, the word "warning"
// or "note".  The colour shows the kind of the remark.
std::string WithColour(const std::string& rendered, Remark::Kind kind, bool has_colours) {
  const std::string word = kind == Remark::Kind::kError ? ":" : std::string(WordOf(kind)) + ":";
  const size_t at = rendered.find(word + " ");
  if (at == std::string::npos) return rendered;
  const Colour colour = kind == Remark::Kind::kError     ? Colour::kError
                        : kind == Remark::Kind::kWarning ? Colour::kWarning
                                                         : Colour::kNote;
  const size_t end = at + word.size();
  return Coloured(colour, rendered.substr(0, end), has_colours) + rendered.substr(end);
}

}  // namespace

std::string Remarks::Shown(const std::string& file) const {
  if (real_root_.empty() || !IsBelow(file, real_root_)) return file;
  const fs::path below = fs::path(file).lexically_relative(real_root_);
  return below == "." ? shown_root_ : (fs::path(shown_root_) / below).string();
}

void Remarks::Add(Remark::Kind kind, const FilePosition& place, std::string text) {
  AddConsequence(kind, place, "", std::move(text));
}

void Remarks::AddConsequence(Remark::Kind kind, const FilePosition& place, std::string cause,
                             std::string text) {
  const std::string file = Shown(place.file);
  for (Remark& known : all_) {
    if (cause.empty() || known.cause != cause || known.kind != kind || known.file != file) continue;
    ++known.count;
    if (known.also_at.size() < kPlacesMax)
      known.also_at.push_back(fmt::format("{}:{}", fs::path(file).filename().string(), place.line));
    return;
  }
  all_.push_back(
      {kind, file, place.line, place.column, std::move(text), place.text, std::move(cause), 1, {}});
}

void Remarks::Error(const std::string& file, std::string text) {
  Add(Remark::Kind::kError, FilePosition{file, 0, 0, ""}, std::move(text));
}

void Remarks::Warning(const std::string& file, std::string text) {
  Add(Remark::Kind::kWarning, FilePosition{file, 0, 0, ""}, std::move(text));
}

void Remarks::Note(const std::string& file, std::string text) {
  Add(Remark::Kind::kNote, FilePosition{file, 0, 0, ""}, std::move(text));
}

void Remarks::AddAll(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& d : diagnostics)
    AddConsequence(KindOf(d.severity), FilePosition{d.file, d.line, d.column, d.text}, d.message,
                   d.message);
}

int Remarks::CountOf(Remark::Kind kind) const {
  return static_cast<int>(
      std::count_if(all_.begin(), all_.end(), [&](const Remark& r) { return r.kind == kind; }));
}

std::string RenderRemarks(const Remarks& remarks, bool has_colours) {
  std::string text;
  for (const Remark& remark : remarks.all()) {
    Diagnostic diagnostic{Severity::kError, remark.file, remark.line,
                          remark.column,    remark.text, remark.source_line};
    if (remark.kind != Remark::Kind::kError)
      diagnostic.message = fmt::format("{}: {}", WordOf(remark.kind), remark.text);
    text += WithColour(Render(diagnostic), remark.kind, has_colours) + "\n";
    if (remark.count < 2) continue;
    const uint64_t rest = remark.count - 1 - remark.also_at.size();
    text += fmt::format("  also at {}{}\n",
                        TerminalLine(fmt::format("{}", fmt::join(remark.also_at, ", "))),
                        rest > 0 ? fmt::format(" and {} more", rest) : "");
  }
  return text;
}

std::string RemarksToJson(const Remarks& remarks, const std::string& folder) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Remark& remark : remarks.all()) {
    list.push_back({{"severity", WordOf(remark.kind)},
                    {"file", remark.file},
                    {"line", remark.line},
                    {"column", remark.column},
                    {"text", remark.text},
                    {"count", remark.count},
                    {"also_at", remark.also_at},
                    {"also_at_left_out", remark.count - 1 - remark.also_at.size()}});
  }
  const nlohmann::ordered_json all = {{"path", folder},
                                      {"errors", remarks.CountOf(Remark::Kind::kError)},
                                      {"warnings", remarks.CountOf(Remark::Kind::kWarning)},
                                      {"notes", remarks.CountOf(Remark::Kind::kNote)},
                                      {"remarks", list}};
  return JsonText(all, 2) + "\n";
}

}  // namespace openr_host
