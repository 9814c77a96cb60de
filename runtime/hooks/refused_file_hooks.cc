// File and network functions of the C library that the robot does not have.  Some take a path of
// the host, others a descriptor, which may be one of the run: its recording or its sockets.
#include <dirent.h>
#include <fcntl.h>
#include <ftw.h>
#include <glob.h>
#include <netdb.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/sendfile.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/statfs.h>
#include <sys/statvfs.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <unistd.h>
#include <utime.h>

#include <cerrno>

#include "runtime/hooks/refuse.h"

using openr_host::Refuses;

// Paths of the host.
OPENR_REFUSE(int, linkat, -1,
             (int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept,
             (from_folder, from, to_folder, to, flags))
OPENR_REFUSE(int, symlinkat, -1, (const char* from, int folder, const char* to) noexcept,
             (from, folder, to))
OPENR_REFUSE(int, unlinkat, -1, (int folder, const char* path, int flags) noexcept,
             (folder, path, flags))
OPENR_REFUSE(int, renameat, -1,
             (int from_folder, const char* from, int to_folder, const char* to) noexcept,
             (from_folder, from, to_folder, to))
OPENR_REFUSE(int, renameat2, -1,
             (int from_folder, const char* from, int to_folder, const char* to,
              unsigned flags) noexcept,
             (from_folder, from, to_folder, to, flags))
OPENR_REFUSE(int, mkdirat, -1, (int folder, const char* path, mode_t mode) noexcept,
             (folder, path, mode))
OPENR_REFUSE(int, mkfifo, -1, (const char* path, mode_t mode) noexcept, (path, mode))
OPENR_REFUSE(int, mkfifoat, -1, (int folder, const char* path, mode_t mode) noexcept,
             (folder, path, mode))
OPENR_REFUSE(int, mknod, -1, (const char* path, mode_t mode, dev_t device) noexcept,
             (path, mode, device))
OPENR_REFUSE(int, mknodat, -1, (int folder, const char* path, mode_t mode, dev_t device) noexcept,
             (folder, path, mode, device))
OPENR_REFUSE(int, mkstemp64, -1, (char* name), (name))
OPENR_REFUSE(int, mkostemp, -1, (char* name, int flags), (name, flags))
OPENR_REFUSE(int, mkstemps, -1, (char* name, int suffix), (name, suffix))
OPENR_REFUSE(int, mkostemps, -1, (char* name, int suffix, int flags), (name, suffix, flags))
OPENR_REFUSE(char*, mkdtemp, nullptr, (char* name) noexcept, (name))
OPENR_REFUSE(FILE*, tmpfile64, nullptr, (), ())
OPENR_REFUSE(int, truncate64, -1, (const char* path, off64_t size) noexcept, (path, size))
OPENR_REFUSE(int, chown, -1, (const char* path, uid_t user, gid_t group) noexcept,
             (path, user, group))
OPENR_REFUSE(int, lchown, -1, (const char* path, uid_t user, gid_t group) noexcept,
             (path, user, group))
OPENR_REFUSE(int, fchmodat, -1, (int folder, const char* path, mode_t mode, int flags) noexcept,
             (folder, path, mode, flags))
OPENR_REFUSE(int, utime, -1, (const char* path, const struct utimbuf* times) noexcept,
             (path, times))
OPENR_REFUSE(int, utimes, -1, (const char* path, const struct timeval times[2]) noexcept,
             (path, times))
OPENR_REFUSE(int, utimensat, -1,
             (int folder, const char* path, const struct timespec times[2], int flags) noexcept,
             (folder, path, times, flags))
OPENR_REFUSE(int, fstatat, -1,
             (int folder, const char* path, struct stat* status, int flags) noexcept,
             (folder, path, status, flags))
OPENR_REFUSE(int, faccessat, -1, (int folder, const char* path, int mode, int flags) noexcept,
             (folder, path, mode, flags))
OPENR_REFUSE(int, statfs, -1, (const char* path, struct statfs* status) noexcept, (path, status))
OPENR_REFUSE(int, statvfs, -1, (const char* path, struct statvfs* status) noexcept, (path, status))
OPENR_REFUSE(ssize_t, readlink, -1, (const char* path, char* text, size_t size) noexcept,
             (path, text, size))
OPENR_REFUSE(char*, realpath, nullptr, (const char* path, char* real) noexcept, (path, real))
OPENR_REFUSE(mode_t, umask, 0, (mode_t mode) noexcept, (mode))
OPENR_REFUSE(int, ftw, -1, (const char* path, __ftw_func_t visit, int folders),
             (path, visit, folders))
OPENR_REFUSE(int, ftw64, -1, (const char* path, __ftw64_func_t visit, int folders),
             (path, visit, folders))
OPENR_REFUSE(int, nftw, -1, (const char* path, __nftw_func_t visit, int folders, int flags),
             (path, visit, folders, flags))
OPENR_REFUSE(int, nftw64, -1, (const char* path, __nftw64_func_t visit, int folders, int flags),
             (path, visit, folders, flags))
OPENR_REFUSE(int, glob, GLOB_ABORTED,
             (const char* pattern, int flags, int (*on_error)(const char*, int),
              glob_t* found) noexcept,
             (pattern, flags, on_error, found))
OPENR_REFUSE(int, glob64, GLOB_ABORTED,
             (const char* pattern, int flags, int (*on_error)(const char*, int),
              glob64_t* found) noexcept,
             (pattern, flags, on_error, found))

// openat() and openat64() get the argument `mode` only with flags that may create a file.  Reading
// it without these flags is harmless, because open() ignores it then.
#define OPENR_REFUSE_OPENAT(name)                                     \
  extern "C" int name(int folder, const char* path, int flags, ...) { \
    static const auto next = OPENR_NEXT(name);                        \
    va_list arguments;                                                \
    va_start(arguments, flags);                                       \
    const mode_t mode = va_arg(arguments, mode_t);                    \
    va_end(arguments);                                                \
    return Refuses(#name) ? -1 : next(folder, path, flags, mode);     \
  }
OPENR_REFUSE_OPENAT(openat)
OPENR_REFUSE_OPENAT(openat64)

// Folders.  Objects get a DIR* that the C library does not know (folder_hooks.cc).
OPENR_REFUSE(DIR*, fdopendir, nullptr, (int descriptor), (descriptor))
OPENR_REFUSE(int, dirfd, -1, (DIR * folder) noexcept, (folder))
OPENR_REFUSE(long, telldir, -1, (DIR * folder) noexcept, (folder))

extern "C" void seekdir(DIR* folder, long place) noexcept {
  static const auto next = OPENR_NEXT(seekdir);
  if (!Refuses("seekdir")) next(folder, place);
}

// Descriptors.
#if __GLIBC_PREREQ(2, 34)  // older versions of the GNU C library do not have close_range()
OPENR_REFUSE(int, close_range, -1, (unsigned first, unsigned last, int flags) noexcept,
             (first, last, flags))
#endif
OPENR_REFUSE(int, ftruncate, -1, (int descriptor, off_t size) noexcept, (descriptor, size))
OPENR_REFUSE(int, ftruncate64, -1, (int descriptor, off64_t size) noexcept, (descriptor, size))
OPENR_REFUSE(int, fallocate, -1, (int descriptor, int mode, off_t from, off_t size),
             (descriptor, mode, from, size))
OPENR_REFUSE(int, fallocate64, -1, (int descriptor, int mode, off64_t from, off64_t size),
             (descriptor, mode, from, size))
OPENR_REFUSE(int, posix_fallocate, ENOSYS, (int descriptor, off_t from, off_t size),
             (descriptor, from, size))
OPENR_REFUSE(int, posix_fallocate64, ENOSYS, (int descriptor, off64_t from, off64_t size),
             (descriptor, from, size))
OPENR_REFUSE(int, fsync, -1, (int descriptor), (descriptor))
OPENR_REFUSE(int, fdatasync, -1, (int descriptor), (descriptor))
OPENR_REFUSE(int, fchmod, -1, (int descriptor, mode_t mode) noexcept, (descriptor, mode))
OPENR_REFUSE(int, fchown, -1, (int descriptor, uid_t user, gid_t group) noexcept,
             (descriptor, user, group))
OPENR_REFUSE(int, futimens, -1, (int descriptor, const struct timespec times[2]) noexcept,
             (descriptor, times))
OPENR_REFUSE(ssize_t, pread, -1, (int descriptor, void* data, size_t size, off_t from),
             (descriptor, data, size, from))
OPENR_REFUSE(ssize_t, pread64, -1, (int descriptor, void* data, size_t size, off64_t from),
             (descriptor, data, size, from))
OPENR_REFUSE(ssize_t, pwrite, -1, (int descriptor, const void* data, size_t size, off_t to),
             (descriptor, data, size, to))
OPENR_REFUSE(ssize_t, pwrite64, -1, (int descriptor, const void* data, size_t size, off64_t to),
             (descriptor, data, size, to))
OPENR_REFUSE(ssize_t, readv, -1, (int descriptor, const struct iovec* parts, int count),
             (descriptor, parts, count))
OPENR_REFUSE(ssize_t, preadv, -1,
             (int descriptor, const struct iovec* parts, int count, off_t from),
             (descriptor, parts, count, from))
OPENR_REFUSE(ssize_t, pwritev, -1, (int descriptor, const struct iovec* parts, int count, off_t to),
             (descriptor, parts, count, to))
OPENR_REFUSE(ssize_t, sendfile, -1, (int to, int from, off_t* offset, size_t size) noexcept,
             (to, from, offset, size))
OPENR_REFUSE(ssize_t, copy_file_range, -1,
             (int from, off64_t* from_offset, int to, off64_t* to_offset, size_t size,
              unsigned flags),
             (from, from_offset, to, to_offset, size, flags))
OPENR_REFUSE(int, vdprintf, -1, (int descriptor, const char* format, va_list arguments),
             (descriptor, format, arguments))

extern "C" int dprintf(int descriptor, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int result = Refuses("dprintf") ? -1 : vdprintf(descriptor, format, arguments);
  va_end(arguments);
  return result;
}

// Looks up the C library's ftruncate() when the runtime is loaded, because later a signal handler
// may be the first caller of ftruncate().
[[gnu::constructor]] static void FindFtruncate() { static_cast<void>(ftruncate(-1, 0) == 0); }

// Sockets.  Programs of the robot use the network by messages to its IP stack.
OPENR_REFUSE(int, bind, -1,
             (int descriptor, const struct sockaddr* address, socklen_t size) noexcept,
             (descriptor, address, size))
OPENR_REFUSE(int, listen, -1, (int descriptor, int waiting) noexcept, (descriptor, waiting))
OPENR_REFUSE(int, shutdown, -1, (int descriptor, int how) noexcept, (descriptor, how))
OPENR_REFUSE(int, connect, -1, (int descriptor, const struct sockaddr* address, socklen_t size),
             (descriptor, address, size))
OPENR_REFUSE(int, accept, -1, (int descriptor, struct sockaddr* address, socklen_t* size),
             (descriptor, address, size))
OPENR_REFUSE(int, accept4, -1,
             (int descriptor, struct sockaddr* address, socklen_t* size, int flags),
             (descriptor, address, size, flags))
OPENR_REFUSE(ssize_t, send, -1, (int descriptor, const void* data, size_t size, int flags),
             (descriptor, data, size, flags))
OPENR_REFUSE(ssize_t, sendto, -1,
             (int descriptor, const void* data, size_t size, int flags,
              const struct sockaddr* address, socklen_t address_size),
             (descriptor, data, size, flags, address, address_size))
OPENR_REFUSE(ssize_t, sendmsg, -1, (int descriptor, const struct msghdr* message, int flags),
             (descriptor, message, flags))
OPENR_REFUSE(ssize_t, recv, -1, (int descriptor, void* data, size_t size, int flags),
             (descriptor, data, size, flags))
OPENR_REFUSE(ssize_t, recvfrom, -1,
             (int descriptor, void* data, size_t size, int flags, struct sockaddr* address,
              socklen_t* address_size),
             (descriptor, data, size, flags, address, address_size))
OPENR_REFUSE(ssize_t, recvmsg, -1, (int descriptor, struct msghdr* message, int flags),
             (descriptor, message, flags))
OPENR_REFUSE(int, getaddrinfo, EAI_SYSTEM,
             (const char* name, const char* service, const struct addrinfo* hints,
              struct addrinfo** list),
             (name, service, hints, list))
OPENR_REFUSE(int, getnameinfo, EAI_SYSTEM,
             (const struct sockaddr* address, socklen_t size, char* host, socklen_t host_size,
              char* service, socklen_t service_size, int flags),
             (address, size, host, host_size, service, service_size, flags))
OPENR_REFUSE(struct hostent*, gethostbyname, nullptr, (const char* name), (name))
OPENR_REFUSE(struct hostent*, gethostbyaddr, nullptr,
             (const void* address, socklen_t size, int family), (address, size, family))

// Processes.

// The same functions under other names, and their near relatives.
OPENR_REFUSE(int, fchdir, -1, (int folder) noexcept, (folder))
// readdir_r() would take a folder of folder_hooks.cc for a DIR of the C library.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
OPENR_REFUSE(int, readdir_r, ENOSYS, (DIR * folder, struct dirent* entry, struct dirent** result),
             (folder, entry, result))
#pragma GCC diagnostic pop
OPENR_REFUSE(int, fstatat64, -1,
             (int folder, const char* path, struct stat64* status, int flags) noexcept,
             (folder, path, status, flags))
OPENR_REFUSE(int, statfs64, -1, (const char* path, struct statfs64* status) noexcept,
             (path, status))
OPENR_REFUSE(int, statvfs64, -1, (const char* path, struct statvfs64* status) noexcept,
             (path, status))
OPENR_REFUSE(ssize_t, readlinkat, -1,
             (int folder, const char* path, char* text, size_t size) noexcept,
             (folder, path, text, size))
OPENR_REFUSE(int, lutimes, -1, (const char* path, const struct timeval times[2]) noexcept,
             (path, times))
OPENR_REFUSE(int, futimes, -1, (int descriptor, const struct timeval times[2]) noexcept,
             (descriptor, times))
OPENR_REFUSE(int, euidaccess, -1, (const char* path, int mode) noexcept, (path, mode))
OPENR_REFUSE(int, eaccess, -1, (const char* path, int mode) noexcept, (path, mode))
OPENR_REFUSE(int, mkostemp64, -1, (char* name, int flags), (name, flags))
OPENR_REFUSE(int, mkstemps64, -1, (char* name, int suffix), (name, suffix))
OPENR_REFUSE(int, mkostemps64, -1, (char* name, int suffix, int flags), (name, suffix, flags))
OPENR_REFUSE(ssize_t, preadv64, -1,
             (int descriptor, const struct iovec* parts, int count, off64_t offset),
             (descriptor, parts, count, offset))
OPENR_REFUSE(ssize_t, pwritev64, -1,
             (int descriptor, const struct iovec* parts, int count, off64_t offset),
             (descriptor, parts, count, offset))
OPENR_REFUSE(ssize_t, sendfile64, -1, (int to, int from, off64_t* offset, size_t size) noexcept,
             (to, from, offset, size))
