#include "kit/build_report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "cli/colour.h"
#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "cli/print_plain.h"
#include "kit/shell_words.h"
#include "kit/source_copies.h"
#include "kit/text_files.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

}  // namespace

BuildReport::BuildReport(const Project& project, const WorkCopy& copy, fs::path work,
                         std::string log)
    : project_(project), copy_(copy), work_(std::move(work)), log_(std::move(log)) {}

// Returns whether the build of some object has failed or could not begin.  A Makefile can ignore
// the failure of a command, so make may succeed although a file has failed.  If make succeeds, only
// failures of files in the objects' folders count, because the program may not need other files.
bool BuildReport::HasFailed(const BuildOutcome& outcome) const {
  const std::vector<KitLog::Failure> failures = ReadKitLog(log_).failures;
  return !outcome.start_problems.empty() ||
         std::any_of(failures.begin(), failures.end(), [&](const KitLog::Failure& failure) {
           return !outcome.is_made || !ObjectOf(failure.file).empty();
         });
}

// Reports the failures of the build: as errors if an image is missing, else as notes.  If all
// images that OBJECT.CFG names are made, the program can run, so a failure is only a note.  The
// reason why make failed is printed last, because people look at the end of the output first.
void BuildReport::AddFailures(BuildOutcome* outcome) const {
  const KitLog log = ReadKitLog(log_);
  for (const KitLog::Repair& repair : log.repairs)
    outcome->notes.push_back(fmt::format("{}: {}", repair.place, repair.what));
  const bool is_complete = outcome->missing.empty() && outcome->problems.empty() &&
                           !(outcome->wants_all && HasFailed(*outcome));
  std::vector<std::string>* const where = is_complete ? &outcome->notes : &outcome->problems;
  for (const KitLog::Failure& failure : log.failures) {
    const std::string text = Described(failure);
    // Reports a source once, because several objects may fail to compile it.
    if (std::find(where->begin(), where->end(), text) == where->end()) where->push_back(text);
  }
  where->insert(where->end(), outcome->start_problems.begin(), outcome->start_problems.end());
  outcome->problems.insert(outcome->problems.end(), outcome->missing.begin(),
                           outcome->missing.end());
  if (is_complete) {
    if (!outcome->make_cause.empty())
      outcome->notes.push_back("make failed: " + outcome->make_cause);
    return;
  }
  const std::vector<std::string> libraries = NeededForeignFiles();
  outcome->problems.insert(outcome->problems.end(), libraries.begin(), libraries.end());
  // Adds the reason why make has failed.  If the log has failures of the compiler or linker, leaves
  // out a reason that only names the failed rule, because those failures say more and are already
  // in the list.
  if (!outcome->is_made &&
      (log.failures.empty() || outcome->make_cause.find("the rule for") != 0) &&
      !outcome->make_cause.empty())
    outcome->problems.push_back("make failed: " + outcome->make_cause);
}

// Returns an error message for each object file or library that the build lacks because the user's
// file is for another processor.  The private copy leaves out such files, because the host cannot
// use them.  The build lacks a file if a Makefile names it and the build has not made it anew.
std::vector<std::string> BuildReport::NeededForeignFiles() const {
  std::string makefiles;
  for (const fs::path& file : project_.makefiles) makefiles += ReadText(file).value_or("");
  std::vector<std::string> lines;
  for (const auto& [original, processor] : copy_.left_out()) {
    const fs::path file = original;
    std::string name = file.filename();
    std::string kind = "object file";
    if (file.extension() == ".a") {
      kind = "library";
      const std::string flag = "-l" + file.stem().string().substr(name.starts_with("lib") ? 3 : 0);
      if (makefiles.find(flag) != std::string::npos) name = flag;
    } else if (file.extension() != ".o") {
      continue;
    }
    std::error_code error;
    if (fs::exists(copy_.PlaceOf(original), error)) continue;
    if (makefiles.find(name) == std::string::npos) continue;
    lines.push_back(
        fmt::format("{}: is a {} for another processor ({}); its sources are needed to build it "
                    "for this machine",
                    original, kind, processor));
  }
  return lines;
}

// Returns the name of the object whose folder contains `file`; "" if no object's folder does.
std::string BuildReport::ObjectOf(const fs::path& file) const {
  for (const ObjectFolder& object : project_.objects) {
    const fs::path build = work_ / "build" / object.folder.lexically_relative(project_.root);
    if (IsBelow(file, object.folder) || IsBelow(file, build.lexically_normal()))
      return object.class_name.empty() ? object.folder.filename().string() : object.class_name;
  }
  return "";
}

// Returns the message for the user about `failure`: "Sender: Chat/Sender/Sender.cc does not
// compile; ..."
std::string BuildReport::Described(const KitLog::Failure& failure) const {
  const std::string object = ObjectOf(failure.file);
  const std::string original = OriginalOf(failure.file, copy_.copies());
  return fmt::format("{}{} {}{}", object.empty() ? "" : object + ": ",
                     original.empty() ? fs::path(failure.file).filename().string() : original,
                     failure.why,
                     failure.why.find("compile") == std::string::npos
                         ? ""
                         : "; the compiler says above what to correct");
}

int PrintOutcome(const BuildOutcome& outcome) {
  std::fflush(stdout);
  const bool has_colours = HasColours(STDERR_FILENO);
  const std::string note_begin = Coloured(Colour::kNote, "openr build: note:", has_colours);
  const std::string problem_begin = Coloured(Colour::kError, "openr build:", has_colours);
  for (const std::string& note : outcome.notes)
    fmt::print(stderr, "{} {}\n", note_begin, TerminalText(note));
  for (const std::string& problem : outcome.problems)
    fmt::print(stderr, "{} {}\n", problem_begin, TerminalText(problem));
  if (!outcome.problems.empty()) return kExitWrong;
  for (const std::string& stick : outcome.sticks)
    PrintPlain("{} run --stick {}\n", ShellWord(ProgramCall()), ShellWord(stick));
  return kExitGood;
}

}  // namespace openr_host
