// Helper functions for text files, folders and file names, used by many parts of the kit.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace openr_host {

std::optional<std::string> ReadText(const std::filesystem::path& file);

// Replaces the content of `file`, and creates missing folders.  Returns "" or the error message.
std::string WriteText(const std::filesystem::path& file, const std::string& text);

std::string LowerCase(std::string text);

// Returns `path` with '_' in place of every character that has a meaning for make or the shell, so
// that old Makefiles work in a folder of this name.
std::string WithoutOddCharacters(std::string path);

// Returns the file or folder in `folder` that is called `name`, ignoring upper and lower case; an
// empty path if there is no such file or folder.
std::filesystem::path FindEntry(const std::filesystem::path& folder, const std::string& name);

// Returns the file or folder `path` below `folder`, such as OPEN-R/MW/CONF, ignoring upper and
// lower case; an empty path if there is no such file or folder.
std::filesystem::path FindBelow(std::filesystem::path folder, const std::string& path);

// Returns `path` below `folder`.  Parts that exist on the disk get the upper and lower case letters
// that they have on the disk.
std::filesystem::path WithCaseOnDisk(std::filesystem::path folder, const std::string& path);

// Returns whether a file of this name is a C or C++ source.
bool IsSourceName(const std::filesystem::path& file);

// Returns whether a file of this name is a header.
bool IsHeaderName(const std::filesystem::path& file);

// Returns whether a file of this name has rules for make.
bool IsMakefileName(const std::filesystem::path& file);

// Returns whether make reads a file of this name without the flag -f.
bool IsMainMakefileName(const std::filesystem::path& file);

// Returns whether the kit ignores the folder, because it cannot hold sources: a folder of version
// control, a hidden folder, or a build folder of CMake.
bool IsIgnoredFolder(const std::filesystem::path& folder);

bool IsBelow(const std::filesystem::path& path, const std::filesystem::path& folder);

// Returns all regular files below `folder`, sorted by name, without the files in folders for which
// IsIgnoredFolder() is true.  Follows links, but not to a folder that contains the link.
std::vector<std::filesystem::path> FilesBelow(const std::filesystem::path& folder);

// Returns the reason why the existing file or folder `path` cannot be read, such as "cannot be
// read: Permission denied"; "" if it can be read.
std::string PathReadProblem(const std::filesystem::path& path);

// Returns the files and folders that exist but cannot be read, among `folder` and all files and
// folders below it.
std::vector<std::filesystem::path> UnreadableBelow(const std::filesystem::path& folder);

}  // namespace openr_host
