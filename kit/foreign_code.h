// Object files and libraries that a build for another machine left behind.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace openr_host {

// The processor that an object file, or an archive of object files, was compiled for: "MIPS".
// "" when that is this machine's, or when `file` is no such file.
std::string ForeignProcessorOf(const std::filesystem::path& file);

// File names of the members of an archive; none when `file` is no archive.
std::vector<std::string> ArchiveMembers(const std::filesystem::path& file);

}  // namespace openr_host
