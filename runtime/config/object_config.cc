#include "runtime/config/object_config.h"

#include <fmt/format.h>

#include "runtime/base/spelling.h"
#include "runtime/config/line_file.h"
#include "runtime/config/stick_path.h"

namespace openr_host {
namespace {

// Returns the line with the path `path` in `objects`, the earlier lines of OBJECT.CFG; nullptr if
// there is none.  Skips lines for another robot design than `section`, because no robot reads the
// lines of both designs.
const ObjectRecord* FindObject(const std::vector<ObjectRecord>& objects, const std::string& path,
                               const std::string& section) {
  for (const ObjectRecord& object : objects) {
    const bool meets = MayBothApply(object.section, section);
    if (meets && EqualsIgnoringCase(object.path, path)) return &object;
  }
  return nullptr;
}

void AddObject(const RecordLine& line, ObjectConfig* config) {
  const Word& path = line.words[0];
  if (!CheckStickPath(path, line.place, "object path", &config->diagnostics)) return;
  if (line.words.size() > 1) {
    config->diagnostics.push_back(
        ErrorAt(line.At(line.words[1]),
                fmt::format("'{}' after the path; a line holds one path", line.words[1].text)));
    return;
  }
  if (const ObjectRecord* first = FindObject(config->objects, path.text, line.section)) {
    config->diagnostics.push_back(
        WarningAt(line.place, fmt::format("'{}' is listed already in line {}; it is loaded once",
                                          path.text, first->place.line)));
    return;
  }
  config->objects.push_back({path.text, line.section, line.place});
}

}  // namespace

ObjectConfig ParseObjectConfig(const std::string& file, std::string_view text,
                               std::string_view design) {
  ObjectConfig config;
  for (const RecordLine& line : ReadRecords(file, text, design, &config.diagnostics)) {
    AddObject(line, &config);
  }
  return config;
}

}  // namespace openr_host
