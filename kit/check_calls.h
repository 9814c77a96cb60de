// Checks the sources of an object for mistakes that are in single words or calls: an index that
// stub.cfg does not make, a macro of the console with too few brackets, a clock that the robot
// lacks.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "kit/check.h"
#include "runtime/config/stub_config.h"

namespace openr_host {

// The path and the text of a source of an object.
struct SourceOfObject {
  std::filesystem::path file;
  std::string text;
};

// Warns of an index sbjX or obsX in subject[sbjX] or observer[obsX] of a source that no line of
// stub.cfg makes.  `code` is the text of everything that may define the index otherwise, without
// comments: all sources and headers of the object.  An index that `code` defines gets no warning.
void CheckServiceIndices(const StubConfig& config, const std::vector<SourceOfObject>& sources,
                         const std::string& code, Remarks* remarks);

// Warns of an index entryX that `sources` use as a selector.  This is a mistake, because the
// selector of an Extra line of stub.cfg is Extra_Entry[entryX].
void CheckExtraEntries(const StubConfig& config, const std::vector<SourceOfObject>& sources,
                       const std::string& code, Remarks* remarks);

// Warns of calls in `sources` that the compiler refuses without telling the reason, or that compile
// and do not work on the robot.  A macro or a function that `code` defines itself gets no warning.
void CheckCalls(const std::vector<SourceOfObject>& sources, const std::string& code,
                Remarks* remarks);

}  // namespace openr_host
