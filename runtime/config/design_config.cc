#include "runtime/config/design_config.h"

#include <fmt/format.h>

#include "runtime/config/line_file.h"
#include "runtime/config/stick_path.h"

namespace openr_host {
namespace {

// The keyword odesignkeywordCPUINFO.  OPENR::FindDesignData() makes the data for this keyword
// without a file, so a line of DESIGNDB.CFG with this keyword has no effect and gets a warning.
constexpr std::string_view kBuiltInKeyword = "SYS_CPUINFO";

bool CheckWords(const RecordLine& line, std::vector<Diagnostic>* diagnostics) {
  const Word& keyword = line.words[0];
  if (line.words.size() == 1) {
    diagnostics->push_back(
        ErrorAt(line.place,
                fmt::format("'{}' stands alone; write a keyword and a path, separated by a blank",
                            keyword.text)));
    return false;
  }
  if (line.words.size() > 2) {
    diagnostics->push_back(
        ErrorAt(line.At(line.words[2]),
                fmt::format("'{}' after the path; a line holds one keyword and one path",
                            line.words[2].text)));
    return false;
  }
  if (keyword.text.size() > static_cast<size_t>(kDesignKeywordBytesMax)) {
    diagnostics->push_back(
        ErrorAt(line.place, fmt::format("keyword of {} characters, the limit is {}",
                                        keyword.text.size(), kDesignKeywordBytesMax)));
    return false;
  }
  if (keyword.text == kBuiltInKeyword) {
    diagnostics->push_back(WarningAt(
        line.place, fmt::format("'{}' is answered by the system itself; the line has no effect",
                                keyword.text)));
    return false;
  }
  return CheckStickPath(line.words[1], line.place, "data path", diagnostics);
}

const DesignRecord* FindDesign(const std::vector<DesignRecord>& designs, const std::string& keyword,
                               const std::string& section) {
  for (const DesignRecord& record : designs) {
    const bool meets = MayBothApply(record.section, section);
    if (meets && record.keyword == keyword) return &record;
  }
  return nullptr;
}

}  // namespace

DesignConfig ParseDesignConfig(const std::string& file, std::string_view text,
                               std::string_view design) {
  DesignConfig config;
  for (const RecordLine& line : ReadRecords(file, text, design, &config.diagnostics)) {
    if (!CheckWords(line, &config.diagnostics)) continue;
    const std::string& keyword = line.words[0].text;
    if (const DesignRecord* first = FindDesign(config.designs, keyword, line.section)) {
      config.diagnostics.push_back(
          WarningAt(line.place, fmt::format("keyword '{}' is given already in line {}, which holds",
                                            keyword, first->keyword_place.line)));
      continue;
    }
    config.designs.push_back(
        {keyword, line.words[1].text, line.section, line.place, line.At(line.words[1])});
  }
  return config;
}

}  // namespace openr_host
