// Building without a Makefile, by how the folders are laid out.
//
// Every object is the sources of its folder, its stub and its .ocf file.  Of the sources that
// belong to no object, it gets those whose header it includes, directly or not; and if then
// something is still undefined, whatever else there is and compiles.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "kit/make_build.h"
#include "kit/project.h"

namespace openr_host {

// File names in lower case, without folders, that the text of a source or header includes.
std::vector<std::string> IncludedNames(const std::string& text);

// The sources among `shared` whose namesake header (Util.h for Util.cc) `sources` include,
// directly or by way of other headers or of those sources.
std::vector<std::filesystem::path> SourcesIncluded(
    const std::vector<std::filesystem::path>& sources,
    const std::vector<std::filesystem::path>& shared);

// Builds `objects` of `project` in folders below `work`.  `plan`: how make was called for them, if
// it was; the flags of their Makefiles count here as well.  Returns what cannot even be tried, a
// line each; what compilers say passes through, and is in the log like the images.
std::vector<std::string> BuildByConvention(const Project& project,
                                           const std::vector<ObjectFolder>& objects,
                                           const MakePlan& plan, const std::filesystem::path& work,
                                           const MakeOptions& options);

}  // namespace openr_host
