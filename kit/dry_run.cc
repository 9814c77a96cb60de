#include "kit/dry_run.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "kit/text_files.h"

namespace openr_host {
namespace {

// Returns the lines of `text`, a Makefile, without comment lines.  A line that ends with a
// backslash is joined with the next line.
std::vector<std::string> LogicalLines(const std::string& text) {
  static const std::regex kContinued("\\\\\r?\n");
  std::istringstream stream(std::regex_replace(text, kContinued, " "));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with('#')) lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> SplitBlanks(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// Returns the file name at the end of a path in a Makefile: "Rules.make" for "$(TOP)/Rules.make".
std::string PathEnd(const std::string& path) { return path.substr(path.rfind('/') + 1); }

// Returns whether `line` begins with text that `pattern` matches, and sets `*match` to this match.
bool BeginsWith(const std::string& line, const std::regex& pattern, std::smatch* match) {
  return std::regex_search(line, *match, pattern, std::regex_constants::match_continuous);
}

// Returns the words of `targets`, the targets of a rule in a Makefile.  If `targets` contains a
// variable, also returns the words of all values that `lines` assign to this variable: for
// "$(DEPEND)" after "DEPEND = .depend", also returns ".depend".  Looks up only the first variable
// of `targets`, and no variables in its values.
std::vector<std::string> ExpandedTargets(const std::string& targets,
                                         const std::vector<std::string>& lines) {
  static const std::regex kReference("\\$[({](\\w+)[)}]");
  // Limits the length of the name, because std::regex calls itself for each character that it
  // matches, so a long line without blanks would overflow the stack.
  static const std::regex kAssignment("\\s*(?:export\\s+)?(\\w{1,200})\\s*[:?+]*=");
  std::vector<std::string> words = SplitBlanks(targets);
  std::smatch reference, assignment;
  if (!std::regex_search(targets, reference, kReference)) return words;
  for (const std::string& line : lines) {
    if (!BeginsWith(line, kAssignment, &assignment) || assignment[1] != reference[1]) continue;
    for (const std::string& word : SplitBlanks(assignment.suffix())) words.push_back(word);
  }
  return words;
}

// Returns whether a rule with the target `target` makes the file `name`.  The target may be a
// pattern ("%.mk") or a suffix rule (".in.mk").
bool IsTargetFor(const std::string& target, const std::string& name) {
  const std::string base = PathEnd(target);
  const size_t percent = base.find('%');
  if (percent != std::string::npos) {
    const std::string before = base.substr(0, percent), after = base.substr(percent + 1);
    return base != "%" && name.size() >= before.size() + after.size() && name.starts_with(before) &&
           name.ends_with(after);
  }
  static const std::regex kSuffixRule("\\.\\w{1,200}(\\.\\w{1,200})");
  std::smatch match;
  return base == name ||
         (std::regex_match(base, match, kSuffixRule) && name.ends_with(match[1].str()));
}

// Returns the targets of the rule that begins with `line`; "" for other lines.
std::string TargetsIn(const std::string& line) {
  const size_t colon = line.find_first_of(":=");
  if (line.starts_with('\t') || colon == std::string::npos || line[colon] == '=') return "";
  const bool is_assignment =
      line.substr(colon).starts_with(":=") || line.substr(colon).starts_with("::=");
  return is_assignment ? "" : line.substr(0, colon);
}

bool HasRuleFor(const std::string& name, const std::vector<std::string>& lines) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    const std::vector<std::string> targets = ExpandedTargets(TargetsIn(line), lines);
    return std::any_of(targets.begin(), targets.end(),
                       [&](const std::string& target) { return IsTargetFor(target, name); });
  });
}

// Returns whether `line` is a line of a recipe that make also runs in a dry run.
bool IsAlwaysRun(const std::string& line) {
  if (line.find("$(MAKE)") != std::string::npos || line.find("${MAKE}") != std::string::npos)
    return true;
  // Finds the beginning of a recipe line, which is at a tab, or after the semicolon of a rule.
  const size_t begin = line.starts_with('\t')    ? 0
                       : TargetsIn(line).empty() ? std::string::npos
                                                 : line.find(';');
  if (begin == std::string::npos) return false;
  const size_t command = line.find_first_not_of(" \t@-", begin + 1);
  return command != std::string::npos && line[command] == '+';
}

}  // namespace

bool DryRunRunsCommands(const std::string& makefiles) {
  static const std::regex kInclude(" *[-s]?include\\s");
  const std::vector<std::string> lines = LogicalLines(makefiles);
  // Names of the Makefiles that make reads: at first those that make looks for by itself, then also
  // those that `lines` include.
  std::set<std::string> read = {"Makefile", "makefile", "GNUmakefile"};
  for (const std::string& line : lines) {
    if (IsAlwaysRun(line)) return true;
    std::smatch match;
    if (!BeginsWith(line, kInclude, &match)) continue;
    const std::string paths = match.suffix();
    for (const std::string& path : SplitBlanks(paths.substr(0, paths.find('#')))) {
      const std::string name = PathEnd(path);
      // Returns true to be safe if the name has a variable or a pattern, or is no name of a
      // Makefile, because the text of such a file may not be in `makefiles`.
      if (name.find_first_of("$*?[") != std::string::npos || !IsMakefileName(name)) return true;
      read.insert(name);
    }
  }
  return std::any_of(read.begin(), read.end(),
                     [&](const std::string& name) { return HasRuleFor(name, lines); });
}

}  // namespace openr_host
