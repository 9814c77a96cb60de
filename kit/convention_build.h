// Builds objects without their Makefiles.  The folder that a file is in says to which object it
// belongs.
//
// An object is made of the sources in its folder, its stub and its .ocf file.  Shared sources,
// which lie in the folder of no object, are added if the object includes their header, directly or
// not.  If names are still undefined at linking, all shared sources that compile are added.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "kit/make_build.h"
#include "kit/project.h"

namespace openr_host {

// Returns the file names that the text of a source or header includes, in lower case and without
// folders.
std::vector<std::string> IncludedNames(const std::string& text);

// Returns the sources among `shared` whose header (Util.h for Util.cc) is included by `sources`,
// directly or by way of other headers or of returned sources.
std::vector<std::filesystem::path> SourcesIncluded(
    const std::vector<std::filesystem::path>& sources,
    const std::vector<std::filesystem::path>& shared);

// Returns how many sources BuildByConvention() compiles for `objects` if no object file is up to
// date.  Does not count the shared sources (in no object's folder) that are added only if names are
// undefined at linking.
uint64_t CountByConvention(const Project& project, const std::vector<ObjectFolder>& objects);

// Builds `objects` of `project` in folders below `work`.  Compiles them with the kit's flags, and
// with the flags (-D, -I, -std ...) of their Makefiles.  If make must run to find these flags, it
// gets the variables of `plan` on its command line.  Returns an error message for each object whose
// build cannot begin, for example without an .ocf file.  Prints the messages of the compilers.
// Failures and images are in the log of `options` (kit_log.h).
std::vector<std::string> BuildByConvention(const Project& project,
                                           const std::vector<ObjectFolder>& objects,
                                           const MakePlan& plan, const std::filesystem::path& work,
                                           const MakeOptions& options);

}  // namespace openr_host
