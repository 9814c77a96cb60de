#include "runtime/core/write_errors.h"

#include <fmt/format.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/system.h"

namespace openr_host {

void ReportWriteError(OpenFiles::File* file, int error) {
  if (file->has_lost) return;
  const ApiScope scope;
  const int kept = errno;
  if (error == 0) {
    // ferror() is true after a failed write, but also after a failed read, which loses no bytes.
    // So this function reports lost bytes only if the disk is full now.
    struct statvfs disk {};
    const bool is_full = statvfs(file->path.c_str(), &disk) == 0 && disk.f_bavail == 0;
    errno = kept;
    if (!is_full) return;
    error = ENOSPC;
  }
  file->has_lost = true;
  const std::string why = std::strerror(error);
  const std::string advice =
      error == ENOSPC ? fmt::format("; make room on the disk that holds {}", file->path) : "";
  t_current.system->AddFinding(Severity::kWarning,
                               fmt::format("{}: not all bytes that were written are in the file: "
                                           "{}{}",
                                           file->name, why, advice));
  errno = kept;
}

void FlushStream(std::FILE* stream, OpenFiles::File* file) {
  const int error = errno;
  if (std::fflush(stream) != 0) {
    ReportWriteError(file, errno);
  } else if (std::ferror(stream) != 0) {
    ReportWriteError(file, 0);
  }
  errno = error;
}

void ReportErrorMark(std::FILE* file) {
  const ApiScope scope;
  OpenFiles& files = t_current.object->files();
  const auto found = files.streams.find(file);
  if (found != files.streams.end() && found->second.writes && std::ferror(file) != 0)
    ReportWriteError(&found->second, 0);
}

void FlushStreams(Object* object) {
  // The map of the object's open streams is ordered by addresses, which differ from run to run.
  // Sorts the streams by the names of their files instead, because the findings are added in this
  // order.
  std::vector<std::pair<std::string, std::FILE*>> streams;
  for (const auto& [stream, file] : object->files().streams) {
    if (file.writes) streams.emplace_back(file.name, stream);
  }
  std::sort(streams.begin(), streams.end());
  const CurrentScope scope(object->system, object);
  for (const auto& [name, stream] : streams)
    FlushStream(stream, &object->files().streams.at(stream));
}

}  // namespace openr_host
