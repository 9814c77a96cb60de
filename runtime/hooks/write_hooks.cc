// Functions that write to an open file: write(), writev() (which std::ofstream calls), fwrite(),
// fflush() and rewind().
//
// These functions return to an object what the functions of the C library return.  If the host's
// disk cannot store all bytes, for instance because it is full, the run also has a finding, because
// programs often ignore such an error.  An error of fprintf(), fputs() and the like is found later:
// by the next fwrite(), fflush() or rewind(), by fclose() (file_hooks.cc), or by FlushStreams() if
// the object does not close the stream.
#include <stdio.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>

#include "runtime/core/system.h"
#include "runtime/core/write_errors.h"
#include "runtime/hooks/hook.h"
#include "runtime/hooks/open_file.h"

using openr_host::ApiScope;
using openr_host::InObject;
using openr_host::OpenFiles;
using openr_host::t_current;

namespace {

// Reports a write by the current object if it has written fewer than `size` bytes.  `result` is the
// number of bytes that were written, or -1 if the write failed; errno then has the reason.
void CheckWritten(int descriptor, ssize_t result, size_t size) {
  if (result >= 0 && static_cast<size_t>(result) == size) return;
  const int error = result < 0 ? errno : 0;
  const ApiScope scope;
  OpenFiles::File* const file = openr_host::FindOpenFile(descriptor);
  if (file != nullptr && file->writes) openr_host::ReportWriteError(file, error);
}

// Reports that the stream `file` has just failed to write; errno has the reason and stays as it is.
void ReportFailedStream(FILE* file) {
  const int error = errno;
  const ApiScope scope;
  OpenFiles& files = t_current.object->files();
  const auto found = files.streams.find(file);
  if (found != files.streams.end() && found->second.writes)
    openr_host::ReportWriteError(&found->second, error);
  errno = error;
}

// Looks up the C library's write() when the runtime is loaded.  Later a signal handler may be the
// first caller of write(), and a look-up is not allowed in a signal handler.
[[gnu::constructor]] void FindWrite() { static_cast<void>(write(-1, nullptr, 0) == 0); }

}  // namespace

extern "C" {

ssize_t write(int descriptor, const void* data, size_t size) {
  static const auto next = OPENR_NEXT(write);
  if (!InObject()) return next(descriptor, data, size);
  if (openr_host::RefusesDescriptor("write", descriptor)) return -1;
  const ssize_t result = next(descriptor, data, size);
  CheckWritten(descriptor, result, size);
  return result;
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
  static const auto next = OPENR_NEXT(writev);
  if (!InObject()) return next(descriptor, parts, count);
  if (openr_host::RefusesDescriptor("writev", descriptor)) return -1;
  const ssize_t result = next(descriptor, parts, count);
  size_t size = 0;
  for (int i = 0; i < count; ++i) size += parts[i].iov_len;
  CheckWritten(descriptor, result, size);
  return result;
}

size_t fwrite(const void* data, size_t size, size_t count, FILE* file) {
  static const auto next = OPENR_NEXT(fwrite);
  const size_t written = next(data, size, count, file);
  // A result of 0 of fwrite() is no failure if `size` is 0, because then there is nothing to write.
  if (written < count && size != 0 && InObject()) ReportFailedStream(file);
  return written;
}

int fflush(FILE* file) {
  static const auto next = OPENR_NEXT(fflush);
  const int result = next(file);
  if (result != 0 && file != nullptr && InObject()) ReportFailedStream(file);
  return result;
}

void rewind(FILE* file) {
  static const auto next = OPENR_NEXT(rewind);
  if (InObject()) {
    // Looks for failed writes first, because rewind() writes the bytes that the stream still holds
    // and then clears the stream's mark of an error.
    const ApiScope scope;
    OpenFiles& files = t_current.object->files();
    const auto found = files.streams.find(file);
    if (found != files.streams.end() && found->second.writes)
      openr_host::FlushStream(file, &found->second);
  }
  next(file);
}

}  // extern "C"
