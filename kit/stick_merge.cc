#include "kit/stick_merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "kit/text_files.h"
#include "runtime/config/line_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// The lines of a configuration file.  `common` has the lines before the first section, which are
// for all robots.  `sections` has all other lines.  Each section begins with a line such as
// [ERS-210] and is for one design of robot.
struct Parts {
  std::vector<std::string> common, sections;
};

Parts Split(const std::string& text) {
  Parts parts;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) line.pop_back();
    const bool begins = !line.empty() && line[line.find_first_not_of(" \t")] == '[';
    (begins || !parts.sections.empty() ? parts.sections : parts.common).push_back(line);
  }
  return parts;
}

std::string WithSingleBlanks(const std::string& line) {
  std::istringstream words(line);
  std::string joined;
  for (std::string word; words >> word;) joined += (joined.empty() ? "" : " ") + word;
  return joined;
}

bool IsRecord(const std::string& line) {
  const size_t at = line.find_first_not_of(" \t");
  return at != std::string::npos && line[at] != '#' && line[at] != '[';
}

bool HasRecord(const Parts& parts) {
  return std::any_of(parts.common.begin(), parts.common.end(), IsRecord) ||
         std::any_of(parts.sections.begin(), parts.sections.end(), IsRecord);
}

// Keys of WLANCONF.TXT (Installation Guide 3.2.2).
const std::set<std::string> kWlanKeys = {"HOSTNAME", "ETHER_IP",     "ETHER_NETMASK", "IP_GATEWAY",
                                         "ESSID",    "WEPENABLE",    "WEPKEY",        "APMODE",
                                         "CHANNEL",  "DNS_SERVER_1", "DNS_DEFDNAME",  "USE_DHCP"};

}  // namespace

std::string MergeConfig(const std::string& base, const std::string& ours) {
  const Parts theirs = Split(base), mine = Split(ours);
  if (!HasRecord(theirs)) return ours;  // the base's file has no records, only comments
  std::set<std::string> known;
  std::string text;
  const auto add = [&](const std::vector<std::string>& lines, bool in_section) {
    for (const std::string& line : lines) {
      // Drops a repeated line of a configuration file only outside of sections, because each
      // section is for another robot and so several sections may need the same line.
      if (IsRecord(line) && !known.insert(WithSingleBlanks(line)).second && !in_section) continue;
      text += line + "\n";
    }
  };
  // Puts our lines that are outside of sections before the sections of the base, because after the
  // first line of a section they would belong to this section.
  add(theirs.common, false);
  add(mine.common, false);
  add(theirs.sections, true);
  add(mine.sections, true);
  return text;
}

std::string ShortNameProblem(const std::string& name) {
  const size_t dot = name.find('.');
  const std::string base = name.substr(0, dot);
  const std::string extension = dot == std::string::npos ? "" : name.substr(dot + 1);
  if (base.empty() || base.size() > 8) {
    return fmt::format("'{}' has {} characters before the dot, the robot's stick takes 1 to 8",
                       name, base.size());
  }
  if (extension.size() > 3) {
    return fmt::format("'{}' has {} characters after the dot, the robot's stick takes at most 3",
                       name, extension.size());
  }
  for (const char c : base + extension) {
    const bool good = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                      std::string("$&#{}~%'()-@^`!_").find(c) != std::string::npos;
    if (!good)
      return fmt::format("'{}' has a '{}', which no name on the robot's stick has", name, c);
  }
  return "";
}

std::vector<Diagnostic> CheckNames(const fs::path& folder) {
  std::vector<Diagnostic> diagnostics;
  std::vector<fs::path> entries;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) entries.push_back(entry);
  std::sort(entries.begin(), entries.end());
  for (const fs::path& entry : entries) {
    const std::string problem = ShortNameProblem(entry.filename());
    if (problem.empty()) continue;
    FilePosition place;
    place.file = entry.lexically_relative(folder);
    diagnostics.push_back(ErrorAt(place, problem));
  }
  return diagnostics;
}

std::vector<Diagnostic> CheckWlanConfig(const std::string& file, const std::string& text) {
  std::vector<Diagnostic> diagnostics;
  for (const FilePosition& line : SplitLines(file, text, &diagnostics)) {
    if (!IsRecord(line.text)) continue;
    const size_t equals = line.text.find('=');
    if (equals == std::string::npos) {
      diagnostics.push_back(ErrorAt(line, "no '='; write KEY=VALUE"));
      continue;
    }
    const size_t blank = line.text.substr(0, equals + 2).find_first_of(" \t");
    if (blank != std::string::npos) {
      diagnostics.push_back(ErrorAt(AtColumn(line, static_cast<int>(blank) + 1),
                                    "a blank beside '=' hangs the boot of the robot; take it out"));
      continue;
    }
    const std::string key = line.text.substr(0, equals);
    if (!kWlanKeys.contains(key)) {
      diagnostics.push_back(
          WarningAt(AtColumn(line, 1), fmt::format("no key '{}' is known to the robot", key)));
    }
  }
  return diagnostics;
}

std::vector<Diagnostic> CheckObjectConfig(const fs::path& stick) {
  std::vector<Diagnostic> diagnostics;
  const fs::path config = FindBelow(stick, "OPEN-R/MW/CONF/OBJECT.CFG");
  const std::string text = ReadText(config).value_or("");
  bool has_power_monitor = false;
  for (const FilePosition& line : SplitLines("OPEN-R/MW/CONF/OBJECT.CFG", text, &diagnostics)) {
    if (!IsRecord(line.text)) continue;
    const std::string path = WithSingleBlanks(line.text);
    // Looks for PowerMonitor, the object that handles the pause button on the robot's own sticks.
    if (LowerCase(path).ends_with("/powermon.bin")) has_power_monitor = true;
    if (!LowerCase(path).starts_with("/ms/")) {
      diagnostics.push_back(ErrorAt(line, fmt::format("'{}' does not begin with /MS/", path)));
    } else if (FindBelow(stick, path.substr(4)).empty()) {
      diagnostics.push_back(
          ErrorAt(line, fmt::format("'{}' is not on the stick; the robot would not boot", path)));
    }
  }
  if (!has_power_monitor) {
    FilePosition place;
    place.file = "OPEN-R/MW/CONF/OBJECT.CFG";
    diagnostics.push_back(
        WarningAt(place, "no POWERMON.BIN: nothing handles the pause button and an empty battery"));
  }
  return diagnostics;
}

}  // namespace openr_host
