// lseek() and fseek() for objects, and the search for the open file of a descriptor.
//
// An object cannot seek behind the size of the largest Memory Stick in a file that it writes.
// Otherwise one written byte could make a file of 1 TB, almost all of it a hole that takes no room
// on the host's disk, and the run would read all of it for the hash of the stick.
#include <fmt/format.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>

#include "runtime/core/system.h"
#include "runtime/hooks/hook.h"
#include "runtime/hooks/open_file.h"

using openr_host::ApiScope;
using openr_host::InObject;
using openr_host::IsConsole;
using openr_host::OpenFiles;
using openr_host::Severity;
using openr_host::t_current;

namespace {

// The size of the largest Memory Stick that was sold, which is generous: the sticks for programs of
// the robot have 8 or 16 MB.
constexpr off_t kStickBytesMax = off_t{128} << 20;

// Returns whether `function` must fail because it has reached the place `offset` of `file`, which
// is larger than a Memory Stick.  If so, adds a finding and sets errno.
bool IsBehindStick(const char* function, const OpenFiles::File* file, off_t offset) {
  if (file == nullptr || !file->writes || offset <= kStickBytesMax) return false;
  const ApiScope scope;
  t_current.system->AddFinding(
      Severity::kWarning,
      fmt::format("{}: {}() to byte {} fails: the largest Memory Stick has {} bytes", file->name,
                  function, offset, kStickBytesMax));
  errno = EFBIG;
  return true;
}

off_t SeekDescriptor(int descriptor, off_t offset, int whence) {
  static const auto next = OPENR_NEXT(lseek);
  if (!InObject()) return next(descriptor, offset, whence);
  if (IsConsole(descriptor)) {
    errno = ESPIPE;  // as for every terminal; the host's standard output may be a file
    return -1;
  }
  if (openr_host::RefusesDescriptor("lseek", descriptor)) return -1;
  const off_t before = next(descriptor, 0, SEEK_CUR);
  const off_t reached = next(descriptor, offset, whence);
  if (reached <= kStickBytesMax ||
      !IsBehindStick("lseek", openr_host::FindOpenFile(descriptor), reached))
    return reached;
  next(descriptor, before, SEEK_SET);
  return -1;
}

int SeekStream(const char* function, FILE* file, off_t offset, int whence) {
  static const auto next = OPENR_NEXT(fseeko);
  if (!InObject()) return next(file, offset, whence);
  const OpenFiles& files = t_current.object->files();
  const auto found = files.streams.find(file);
  if (found == files.streams.end()) return next(file, offset, whence);
  const off_t before = ftello(file);
  const int result = next(file, offset, whence);
  if (result != 0 || !IsBehindStick(function, &found->second, ftello(file))) return result;
  const int error = errno;
  next(file, before, SEEK_SET);
  errno = error;
  return -1;
}

// Looks up the C library's lseek() when the runtime is loaded, because later a signal handler may
// be the first caller of lseek().
[[gnu::constructor]] void FindSeek() { static_cast<void>(lseek(-1, 0, SEEK_CUR) == 0); }

}  // namespace

namespace openr_host {

OpenFiles::File* FindOpenFile(int descriptor) {
  OpenFiles::File* result = nullptr;
  AnyObjectOfRobot([&](Object* object) {
    OpenFiles& files = object->files();
    const auto found = files.descriptors.find(descriptor);
    if (found != files.descriptors.end()) result = &found->second;
    for (auto& [stream, file] : files.streams) {
      if (fileno(stream) == descriptor) result = &file;
    }
    return result != nullptr;
  });
  return result;
}

bool RefusesDescriptor(const char* function, int descriptor) {
  if (descriptor < 0 || IsConsole(descriptor)) return false;
  const ApiScope scope;
  if (FindOpenFile(descriptor) != nullptr) return false;
  // Does not name the descriptor, because its number may differ from run to run.
  t_current.system->AddFinding(
      Severity::kWarning,
      fmt::format("{}() fails: no object of this robot has a file open with this descriptor; it "
                  "may be closed already, or was never set",
                  function));
  errno = EBADF;
  return true;
}

}  // namespace openr_host

extern "C" {

off_t lseek(int descriptor, off_t offset, int whence) noexcept {
  return SeekDescriptor(descriptor, offset, whence);
}
off64_t lseek64(int descriptor, off64_t offset, int whence) noexcept {
  return SeekDescriptor(descriptor, offset, whence);
}

int fseek(FILE* file, long offset, int whence) { return SeekStream("fseek", file, offset, whence); }
int fseeko(FILE* file, off_t offset, int whence) {
  return SeekStream("fseeko", file, offset, whence);
}
int fseeko64(FILE* file, off64_t offset, int whence) {
  return SeekStream("fseeko64", file, offset, whence);
}

}  // extern "C"
