// Small things about files and their names that many parts of the kit need.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace openr_host {

std::optional<std::string> ReadText(const std::filesystem::path& file);

// Makes the folders that are missing; else as WriteFile().
std::string WriteText(const std::filesystem::path& file, const std::string& text);

std::string LowerCase(std::string text);

// `path` with '_' for every character that make or the shell would take apart.
std::string WithoutOddCharacters(std::string path);

// The entry of `folder` that is called `name` in any case; an empty path if there is none.
std::filesystem::path FindEntry(const std::filesystem::path& folder, const std::string& name);

// The same for several parts: OPEN-R/MW/CONF.
std::filesystem::path FindBelow(std::filesystem::path folder, const std::string& path);

// `path` below `folder`, with the parts that are there in any case as they are spelt there.
std::filesystem::path SpeltBelow(std::filesystem::path folder, const std::string& path);

// Whether a file of this name is a C or C++ source, a header, or made of Makefile rules.
bool IsSourceName(const std::filesystem::path& file);
bool IsHeaderName(const std::filesystem::path& file);
bool IsMakefileName(const std::filesystem::path& file);
// One that make finds by itself.
bool IsMainMakefileName(const std::filesystem::path& file);

// Folders of version control, hidden ones, and what CMake builds in: not sources.
bool IsIgnoredFolder(const std::filesystem::path& folder);

bool IsBelow(const std::filesystem::path& path, const std::filesystem::path& folder);

// All regular files below `folder`, in order of names, without ignored folders; links are
// followed, but not in circles.
std::vector<std::filesystem::path> FilesBelow(const std::filesystem::path& folder);

// "" or "cannot be read: Permission denied" of a file or folder that is there.
std::string WhyUnreadable(const std::filesystem::path& path);

// `folder` and what is below it, as far as it is there and may not be read.
std::vector<std::filesystem::path> UnreadableBelow(const std::filesystem::path& folder);

}  // namespace openr_host
