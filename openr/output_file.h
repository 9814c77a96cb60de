// Files a command is to write, looked at before it begins its work.
#pragma once

#include <filesystem>
#include <string>

namespace openr_host {

// Why `file` cannot be written, or "".  Leaves everything as it was: a file that exists keeps
// its content, one that does not is not left behind.
std::string WhyNotWritable(const std::string& file);

// Why `folder` can be neither made nor written into, or "".  Makes nothing.
std::string WhyNoFolder(const std::string& folder);

// "FILE: why", for people.
std::string Explain(const std::filesystem::filesystem_error& error);

// Writes all of `text` to `file`, replacing what was there.  Returns "" or what went wrong, with
// the file's name.
std::string WriteFile(const std::string& file, const std::string& text);

}  // namespace openr_host
