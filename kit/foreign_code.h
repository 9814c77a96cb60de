// Recognises object files and libraries that were built for another processor.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace openr_host {

// Returns the processor that an object file or an archive of object files was compiled for, such as
// "MIPS".  Returns "" if that is the processor of this machine, and for files of other kinds.
std::string ForeignProcessorOf(const std::filesystem::path& file);

// Returns the file names of the members of an archive; none if `file` is no archive.
std::vector<std::string> ArchiveMembers(const std::filesystem::path& file);

}  // namespace openr_host
