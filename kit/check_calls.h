// Finds mistakes in the sources of an object, such as the index of a service that stub.cfg does not
// have, OSYSPRINT("text") without a second pair of brackets, and a call of a clock that the robot
// lacks.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "kit/remarks.h"
#include "runtime/config/stub_config.h"

namespace openr_host {

// The path and the text of a source of an object.
struct SourceOfObject {
  std::filesystem::path file;
  std::string text;
};

// Warns of each index sbjX in subject[sbjX], and obsX in observer[obsX], that `sources` use and for
// which stub.cfg has no service.  `code` is the text of all sources and headers of the object,
// without comments.  An index that `code` defines itself gets no warning.
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
