#include "kit/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/process.h"
#include "cli/standard_streams.h"
#include "kit/sdk_paths.h"
#include "kit/shell_words.h"
#include "kit/text_files.h"
#include "kit/work_copy.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Returns the files of counts (.gcda) that runs have written below `work`, sorted.
std::vector<fs::path> CountFiles(const fs::path& work) {
  std::vector<fs::path> files = FilesBelow(work);
  std::erase_if(files, [](const fs::path& file) { return file.extension() != ".gcda"; });
  std::sort(files.begin(), files.end());
  return files;
}

LineCounts ReadCounts(const std::vector<fs::path>& files, const fs::path& work) {
  std::vector<std::string> command{"gcov", "--json-format", "--stdout"};
  for (const fs::path& file : files) command.push_back(file);
  const ProcessResult result =
      RunProcess(command, {.environment = {{"LC_ALL", "C"}}, .folder = work, .captures_out = true});
  if (!result.start_error.empty()) throw std::runtime_error(result.start_error);
  if (!result.good()) throw std::runtime_error("gcov cannot read the counts; it says why above");
  LineCounts counts;
  AddGcovCounts(result.output, &counts);
  return counts;
}

// Returns the counts of executed lines of the user's own sources in `folder`.  The build has
// compiled private copies of these sources, which are below `work`.  So `counts` has a source under
// the path of its copy.  If the compile command had an absolute path, `counts` has the source under
// its own path (-ffile-prefix-map).  Looks up both paths.  Leaves out the headers of the SDK and of
// the C++ library, and the stubs, which openr build makes.
LineCounts OfOriginals(const LineCounts& counts, const fs::path& folder, const fs::path& work) {
  const WorkCopy copy(work, SdkRoot());
  LineCounts own;
  for (const fs::path& file : FilesBelow(folder)) {
    for (const fs::path& name : {copy.PlaceOf(file), file}) {
      const auto found = counts.find(name);
      if (found == counts.end()) continue;
      for (const auto& [line, count] : found->second) own[file][line] += count;
    }
  }
  return own;
}

struct Sum {
  size_t run = 0;
  size_t all = 0;
  double percent() const {
    return all == 0 ? 100.0 : 100.0 * static_cast<double>(run) / static_cast<double>(all);
  }
};

Sum SumOf(const std::map<int, uint64_t>& lines) {
  Sum sum;
  sum.all = lines.size();
  for (const auto& [line, count] : lines) sum.run += count > 0;
  return sum;
}

Sum SumOf(const LineCounts& counts) {
  Sum sum;
  for (const auto& [file, lines] : counts) {
    sum.run += SumOf(lines).run;
    sum.all += lines.size();
  }
  return sum;
}

std::string AsTable(const LineCounts& counts, const fs::path& folder) {
  std::string text;
  for (const auto& [file, lines] : counts) {
    const Sum sum = SumOf(lines);
    const std::string missed = LinesNotRun(lines);
    text += fmt::format("{:5.1f} % {:>5} of {:>5} lines  {}{}{}\n", sum.percent(), sum.run, sum.all,
                        fs::path(file).lexically_relative(folder).string(),
                        missed.empty() ? "" : "; not run: ", missed);
  }
  const Sum sum = SumOf(counts);
  return text + fmt::format("{:5.1f} % {:>5} of {:>5} lines\n", sum.percent(), sum.run, sum.all);
}

nlohmann::ordered_json AsJson(const LineCounts& counts, const fs::path& folder) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const auto& [file, lines] : counts) {
    nlohmann::ordered_json by_line = nlohmann::ordered_json::object();
    for (const auto& [line, count] : lines) by_line[std::to_string(line)] = count;
    files.push_back({{"file", fs::path(file).lexically_relative(folder).string()},
                     {"lines", SumOf(lines).all},
                     {"lines_run", SumOf(lines).run},
                     {"counts", by_line}});
  }
  return {{"lines", SumOf(counts).all}, {"lines_run", SumOf(counts).run}, {"files", files}};
}

// Returns the counts of executed lines in the format that lcov, genhtml and editors read.
std::string AsLcov(const LineCounts& counts) {
  std::string text = "TN:\n";
  for (const auto& [file, lines] : counts) {
    text += fmt::format("SF:{}\n", file);
    for (const auto& [line, count] : lines) text += fmt::format("DA:{},{}\n", line, count);
    text += fmt::format("LF:{}\nLH:{}\nend_of_record\n", lines.size(), SumOf(lines).run);
  }
  return text;
}

// Returns the command with which the user builds the folder for coverage.
std::string BuildCommand(const CoverageOptions& options) {
  return fmt::format("{} build --coverage {}", ShellWord(ProgramCall()), ShellWord(options.folder));
}

}  // namespace

void AddGcovCounts(const std::string& json, LineCounts* counts) {
  std::istringstream documents(json);
  for (std::string line; std::getline(documents, line);) {
    if (line.empty()) continue;
    const auto document = TryParseJson<nlohmann::json>(line);
    if (!document.is_object() || !document.contains("files"))
      throw std::runtime_error("gcov printed no JSON; gcov 9 or later is needed");
    const fs::path here = document.value("current_working_directory", "");
    for (const auto& file : document["files"]) {
      const fs::path name = (here / file.value("file", "")).lexically_normal();
      for (const auto& entry : file["lines"])
        (*counts)[name][entry.value("line_number", 0)] += entry.value("count", uint64_t{0});
    }
  }
}

std::string LinesNotRun(const std::map<int, uint64_t>& lines) {
  std::string text;
  for (auto it = lines.begin(); it != lines.end();) {
    if (it->second > 0) {
      ++it;
      continue;
    }
    const int first = it->first;
    int last = first;
    for (; it != lines.end() && it->second == 0; ++it) last = it->first;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", first);
    if (last > first) text += fmt::format("-{}", last);
  }
  return text;
}

int ShowCoverage(const CoverageOptions& options) {
  std::error_code error;
  const fs::path folder = fs::canonical(options.folder, error);
  if (error) throw std::runtime_error(options.folder + ": " + error.message());
  const fs::path work =
      fs::weakly_canonical(options.work.empty() ? DefaultWorkFolder(folder, BuildVariant::kCoverage)
                                                : fs::absolute(options.work));
  if (!fs::is_directory(work, error)) {
    throw std::runtime_error(fmt::format("{}: was not built with --coverage; {}", options.folder,
                                         BuildCommand(options)));
  }
  const std::vector<fs::path> files = CountFiles(work);
  if (options.resets) {
    for (const fs::path& file : files) fs::remove(file);
    return kExitGood;
  }
  if (files.empty()) {
    throw std::runtime_error(
        fmt::format("{}: no run has left counts; run its stick after '{}', up to a regular end",
                    options.folder, BuildCommand(options)));
  }
  const LineCounts counts = OfOriginals(ReadCounts(files, work), folder, work);
  if (!options.lcov.empty()) {
    const std::string problem = WriteFile(options.lcov, AsLcov(counts));
    if (!problem.empty()) throw std::runtime_error(problem);
  }
  PrintAnswer(options.is_json ? JsonText(AsJson(counts, folder)) + "\n"
                              : TerminalText(AsTable(counts, folder)));
  return kExitGood;
}

}  // namespace openr_host
