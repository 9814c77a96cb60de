#include "kit/source_repair.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "cli/json_text.h"
#include "kit/asm_repair.h"
#include "kit/repair_rules.h"
#include "kit/sdk_paths.h"
#include "kit/source_text.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Returns the errors in the output of g++.  The output has JSON arrays, each on one line, and other
// lines between them.
std::vector<CompilerError> ReadCompilerErrors(const std::string& diagnostics) {
  std::vector<CompilerError> errors;
  std::istringstream lines(diagnostics);
  for (std::string line; std::getline(lines, line);) {
    const auto parsed = TryParseJson<nlohmann::json>(line);
    if (!parsed.is_array()) continue;
    for (const auto& entry : parsed) {
      const std::string kind = entry.value("kind", "");
      if (kind.find("error") == std::string::npos || !entry.contains("locations") ||
          entry["locations"].empty()) {
        continue;
      }
      const auto& caret = entry["locations"][0]["caret"];
      errors.push_back({entry.value("message", ""),
                        fs::absolute(caret.value("file", "")).lexically_normal(),
                        caret.value("line", 0), caret.value("byte-column", 0)});
    }
  }
  return errors;
}

// Returns the errors of the assembler: "a.cc:3: Error: no such instruction: ...".  For assembly
// outside of functions, the assembler names its own input (.s) and not a source.  Such an
// error may come from any of `sources`, the files that were given to the compiler.  So returns the
// error once for each of these files.
std::vector<CompilerError> ReadAssemblerErrors(const std::string& diagnostics,
                                               const std::vector<std::string>& sources) {
  static const std::regex kError("^([^:\n]+):(\\d+): (?:Error|Fatal error): (.*)$");
  std::vector<CompilerError> errors;
  std::istringstream lines(diagnostics);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, kError)) continue;
    const std::string message = kAssemblerSays + match[3].str();
    if (!match[1].str().ends_with(".s")) {
      errors.push_back(
          {message, fs::absolute(match[1].str()).lexically_normal(), std::stoi(match[2]), 1});
      continue;
    }
    for (const std::string& source : sources)
      errors.push_back({message, fs::absolute(source).lexically_normal(), 0, 0});
  }
  return errors;
}

// Applies `edits` to `text` and returns the result.  The edits must not overlap.  The last edit in
// the text is made first, so that the positions of the other edits stay right.
std::string Edited(std::string text, std::vector<Edit> edits) {
  std::sort(edits.begin(), edits.end(),
            [](const Edit& a, const Edit& b) { return a.begin > b.begin; });
  for (const Edit& edit : edits) text.replace(edit.begin, edit.end - edit.begin, edit.text);
  return text;
}

// Returns whether an edit of `edits` overlaps an edit of `others`.  Edits that only touch count as
// well, because two insertions at the same position depend on their order.
bool Overlaps(const std::vector<Edit>& edits, const std::vector<Edit>& others) {
  return std::any_of(edits.begin(), edits.end(), [&](const Edit& edit) {
    return std::any_of(others.begin(), others.end(), [&](const Edit& other) {
      return edit.begin <= other.end && other.begin <= edit.end;
    });
  });
}

// Writes the file and keeps its old time, so that make does not see a change.
void WriteWithTime(const std::string& file, const std::string& text) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  const auto permissions = fs::status(file, error).permissions();
  WriteText(file, text);
  fs::permissions(file, permissions, error);
  fs::last_write_time(file, time, error);
}

}  // namespace

RepairSession::RepairSession() : copies_(SourceCopies()) {
  const char* const log = std::getenv(kLogVariable);
  // Takes no lock if there are no private copies, because no file is repaired then (may_repair()).
  if (log == nullptr || copies_.empty()) return;
  lock_ = open((std::string(log) + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  // Waits for other processes of the compiler, because they may be repairing the same headers.
  if (lock_ >= 0) flock(lock_, LOCK_EX);
}

RepairSession::~RepairSession() {
  if (lock_ >= 0) close(lock_);
}

// Adds to `edits_of` the edits of headers that remove assembly from macros.  Called if the compiler
// complains about assembly in a line of `text` that has none, because the assembly then comes from
// a macro of a header.
void RepairSession::AddMacroEdits(const CompilerError& error, const std::string& text,
                                  std::map<std::string, std::vector<Edit>>* edits_of) {
  const size_t begin = OffsetOf(text, error.line, 1);
  if (begin == kNone) return;
  const std::string line = text.substr(begin, text.find('\n', begin) - begin);
  for (const SourceCopy& entry : copies_) {
    for (const fs::path& file : FilesBelow(entry.copy)) {
      if (!IsHeaderName(file)) continue;
      const std::string header = ReadText(file).value_or("");
      if (header.find("asm") == std::string::npos) continue;
      for (const Edit& edit : AssemblyMacroRepairOf(line, header)) {
        std::vector<Edit>& all = (*edits_of)[file];
        if (Overlaps({edit}, all)) continue;
        all.push_back(edit);
        repairs_.push_back({OriginalOf(file, copies_), edit.what});
      }
    }
  }
}

bool RepairSession::Apply(const std::string& diagnostics, const std::vector<std::string>& sources) {
  std::vector<std::string> headers;
  std::map<std::string, std::vector<Edit>> edits_of;
  std::vector<CompilerError> errors = ReadCompilerErrors(diagnostics);
  const std::vector<CompilerError> more = ReadAssemblerErrors(diagnostics, sources);
  errors.insert(errors.end(), more.begin(), more.end());
  // Ignores the compiler's messages about undeclared names in this round of repairs if a 'typename'
  // is missing, because the missing 'typename' may be the cause of these messages.  A later round
  // repairs the names that are still undeclared.
  const bool is_unclear = diagnostics.find("need 'typename'") != std::string::npos;
  for (const CompilerError& error : errors) {
    if (is_unclear && error.message.find("not declared") != std::string::npos) continue;
    // Repairs only files of the private copies.  Other files, such as headers of the SDK tree,
    // serve other builds, too.
    if (OriginalOf(error.file, copies_).empty()) continue;
    const std::string text = ReadText(error.file).value_or("");
    if (headers.empty() && error.message.find("No such file") != std::string::npos) {
      for (const SourceCopy& entry : copies_) {
        for (const fs::path& file : FilesBelow(entry.copy)) headers.push_back(file);
      }
      for (const fs::path& file : FilesBelow(SdkRoot() + "/OPEN_R/include/OPENR"))
        headers.push_back(file);
    }
    const std::vector<Edit> edits = RepairOf(error, text, headers);
    if (edits.empty() && error.line > 0 && IsAboutAssembly(error))
      AddMacroEdits(error, text, &edits_of);
    std::vector<Edit>& all = edits_of[error.file];
    if (edits.empty() || Overlaps(edits, all)) continue;
    all.insert(all.end(), edits.begin(), edits.end());
    repairs_.push_back(
        {fmt::format("{}:{}", OriginalOf(error.file, copies_), error.line), edits[0].what});
  }
  bool changed = false;
  for (const auto& [file, edits] : edits_of) {
    if (edits.empty()) continue;
    const std::string text = ReadText(file).value_or("");
    // Keeps only the text that the file had before the first round of repairs, because Undo() takes
    // back all rounds.
    former_.emplace(file, text);
    WriteWithTime(file, Edited(text, edits));
    changed = true;
  }
  return changed;
}

void RepairSession::Keep() {
  for (const KitLog::Repair& repair : repairs_) LogRepair(repair);
}

void RepairSession::Undo() {
  for (const auto& [file, text] : former_) WriteWithTime(file, text);
}

}  // namespace openr_host
