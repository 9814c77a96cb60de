// Copies files and folders.  If the disk becomes full, or the file is larger than the shell's limit
// (ulimit -f), the error says so.
//
// std::filesystem reports an input/output error if a copy fails in its middle for such a reason.  A
// user then looks for a defect of the disk, so these functions report ENOSPC or EFBIG instead.
#pragma once

#include <filesystem>
#include <system_error>

namespace openr_host {

// Copies the file `from` to `to` as std::filesystem::copy_file() does, and returns its error.  If
// the copy fails and `to` did not exist before, removes the incomplete `to`.
std::error_code TryCopyFile(
    const std::filesystem::path& from, const std::filesystem::path& to,
    std::filesystem::copy_options options = std::filesystem::copy_options::none);

// Copies a file as TryCopyFile() does, but throws std::filesystem::filesystem_error after an error.
void CopyFile(const std::filesystem::path& from, const std::filesystem::path& to,
              std::filesystem::copy_options options = std::filesystem::copy_options::none);

// Copies the folder `from`, with all that is in it, to the folder `to`, which is made if it does
// not exist.  Files are copied as CopyFile() does.  Follows symbolic links.
void CopyFolder(const std::filesystem::path& from, const std::filesystem::path& to,
                std::filesystem::copy_options options = std::filesystem::copy_options::none);

}  // namespace openr_host
