#include "kit/controller_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "cli/process.h"
#include "kit/text_files.h"
#include "runtime/base/temp_folder.h"
#include "runtime/config/line_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

bool IsControllerSource(const fs::path& file) {
  const std::string extension = file.extension();
  return extension == ".c" || extension == ".cc" || extension == ".cpp";
}

std::vector<fs::path> SourcesIn(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file(error) && IsControllerSource(entry.path()))
      found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// The text of a Makefile that prints the values of all variables that the file $(LIST) sets, each
// on a line that begins with "= ".  Any variable may have the list of sources, so all values are
// printed, without the names of the variables.
constexpr char kPrintVariables[] =
    "include $(LIST)\n"
    "$(foreach v,$(filter-out MAKE% .% CURDIR SHELL LIST,$(.VARIABLES)),"
    "$(if $(filter file,$(origin $(v))),$(info = $($(v)))))\n"
    "openr-nothing:;\n";

// Returns an error with the text `message`.  Its place is the first occurrence of `word` in the
// file `list`, whose content is `text`.  If `word` does not occur, the place is the first line.
Diagnostic AtWord(const fs::path& list, const std::string& text, const std::string& word,
                  std::string message) {
  std::vector<Diagnostic> ignored;
  FilePosition place{list, 1, 1, ""};
  for (const FilePosition& line : SplitLines(list, text, &ignored)) {
    const size_t at = line.text.find(word);
    if (line.line > 1 && at == std::string::npos) continue;
    place = line;
    place.column = at == std::string::npos ? 1 : static_cast<int>(at) + 1;
    if (at != std::string::npos) break;
  }
  return ErrorAt(place, std::move(message));
}

void ReadList(const fs::path& folder, ControllerSources* sources) {
  const std::string text = ReadText(sources->list).value_or("");
  // Runs make to get the values of the variables, because the Makefile may build its list of
  // sources with functions and conditions of make.
  const TempFolder scratch;
  const std::string makefile = scratch.path() + "/print.mk";
  if (!WriteText(makefile, kPrintVariables).empty()) return;
  const ProcessResult made =
      RunProcess({"make", "-s", "-f", makefile, "-C", folder,
                  "LIST=" + sources->list.filename().string(), "openr-nothing"},
                 {.environment = {{"MAKEFLAGS", ""}, {"MAKELEVEL", ""}},
                  .captures_error = true,
                  .captures_out = true,
                  .has_no_input = true});
  if (!made.good()) {
    sources->diagnostics.push_back(AtWord(sources->list, text, "", "make says: " + made.output));
    return;
  }
  bool has_words = false;
  std::istringstream lines(made.output);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("= ")) continue;
    std::istringstream words(line.substr(2));
    for (std::string word; words >> word;) {
      has_words = true;
      if (!IsControllerSource(word)) continue;
      const fs::path file = (folder / word).lexically_normal();
      // Takes each source once, because several variables of the Makefile may name it.
      if (std::find(sources->files.begin(), sources->files.end(), file) != sources->files.end())
        continue;
      sources->files.push_back(file);
      if (fs::is_regular_file(file)) continue;
      sources->diagnostics.push_back(
          AtWord(sources->list, text, word, fmt::format("there is no file '{}'", word)));
    }
  }
  // Reports a Makefile.sources whose variables have words but no sources.  A list without any word
  // is no error, because it asks for a controller without sources, which does nothing.
  if (has_words && sources->files.empty()) {
    sources->diagnostics.push_back(
        AtWord(sources->list, text, "",
               "names no source (*.c, *.cc, *.cpp); 'SOURCES =' makes the empty controller"));
  }
}

}  // namespace

ControllerSources FindControllerSources(const fs::path& folder) {
  ControllerSources sources;
  sources.list = FindEntry(folder, "Makefile.sources");
  if (sources.list.empty()) {
    sources.files = SourcesIn(folder);
  } else {
    ReadList(folder, &sources);
  }
  return sources;
}

bool IsControllerFolder(const fs::path& folder) {
  if (!FindEntry(folder, "Makefile.sources").empty()) return true;
  static const std::regex kInclude("#[ \t]*include[ \t]*[<\"](device/)?robot\\.h[>\"]");
  const std::vector<fs::path> files = SourcesIn(folder);
  return std::any_of(files.begin(), files.end(), [](const fs::path& file) {
    return std::regex_search(ReadText(file).value_or(""), kInclude);
  });
}

}  // namespace openr_host
