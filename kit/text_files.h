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

// Returns the file or folder in `folder` that is called `name`, in upper or lower case; an empty
// path if there is none.
std::filesystem::path FindEntry(const std::filesystem::path& folder, const std::string& name);

// Returns the file or folder `path` below `folder`, such as OPEN-R/MW/CONF, with each part in upper
// or lower case; an empty path if there is none.
std::filesystem::path FindBelow(std::filesystem::path folder, const std::string& path);

// Returns `path` below `folder`.  Parts that exist, in any case, are written as on the disk.
std::filesystem::path SpeltBelow(std::filesystem::path folder, const std::string& path);

// Return whether a file of this name is a C or C++ source, a header, or a file with rules for make.
bool IsSourceName(const std::filesystem::path& file);
bool IsHeaderName(const std::filesystem::path& file);
bool IsMakefileName(const std::filesystem::path& file);
// Returns whether make finds a file of this name without -f.
bool IsMainMakefileName(const std::filesystem::path& file);

// Returns whether the kit ignores the folder, because it cannot hold sources: a folder of version
// control, a hidden folder, or a build folder of CMake.
bool IsIgnoredFolder(const std::filesystem::path& folder);

bool IsBelow(const std::filesystem::path& path, const std::filesystem::path& folder);

// Returns all regular files below `folder`, sorted by name, without ignored folders.  Follows
// links, but not to a folder that contains the link.
std::vector<std::filesystem::path> FilesBelow(const std::filesystem::path& folder);

// Returns the reason why the existing file or folder `path` cannot be read, such as "cannot be
// read: Permission denied"; "" if it can be read.
std::string WhyUnreadable(const std::filesystem::path& path);

// Returns those of `folder` and the files and folders below it that exist but cannot be read.
std::vector<std::filesystem::path> UnreadableBelow(const std::filesystem::path& folder);

}  // namespace openr_host
