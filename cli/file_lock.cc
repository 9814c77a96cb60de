#include "cli/file_lock.h"

#include <fmt/format.h>

#include <sstream>

#include "runtime/base/read_file.h"

namespace openr_host {

// Looks for the file in /proc/locks, whose lines look like "3: FLOCK  ADVISORY  WRITE 1234
// 08:01:5678 0 EOF".  In this line, 1234 is the process, 08:01 the device and 5678 the inode of the
// file.  In a container, stat() gives another device than /proc/locks, so only the inodes are
// compared.
std::string DescribeWriter(const struct stat& file) {
  const std::string inode = fmt::format(":{}", file.st_ino);
  std::istringstream locks(ReadFile("/proc/locks").value_or(""));
  for (std::string line; std::getline(locks, line);) {
    std::istringstream words(line);
    std::string number, kind, mode, access, place;
    int process = 0;
    if (!(words >> number >> kind >> mode >> access >> process >> place)) continue;
    if (kind != "FLOCK" || process <= 0 || !place.ends_with(inode)) continue;
    std::istringstream comm(ReadFile(fmt::format("/proc/{}/comm", process)).value_or(""));
    std::string name;
    if (!std::getline(comm, name)) return fmt::format("process {}", process);
    return fmt::format("process {} ({})", process, name);
  }
  return "another process";
}

std::string IsBeingWritten(const std::string& file, const struct stat& status) {
  return fmt::format("{}: is being written by {}; name another file, or wait for its end", file,
                     DescribeWriter(status));
}

}  // namespace openr_host
