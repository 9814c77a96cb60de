// opendir(), readdir(), closedir(), rewinddir() and scandir() for objects: they show a folder of
// the stick as the robot's FAT file system would (Programmer's Guide, appendix A).
#include <dirent.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "runtime/core/system.h"
#include "runtime/hooks/hook.h"
#include "runtime/hooks/stick_call.h"
#include "runtime/stick/memory_stick.h"

using openr_host::ApiScope;
using openr_host::InObject;
using openr_host::Severity;
using openr_host::t_current;

namespace {

constexpr size_t kEntriesMax = 682;  // the robot's readdir() returns at most this many names

// A folder that an object has opened.  The DIR* that the object gets points to this struct.  The
// struct is on the object's heap, because it is part of the object's state.
struct Folder {
  size_t count;
  size_t next;
  struct dirent entry;
  struct Name {
    char text[13];  // the name, such as "NAME.EXT", and its NUL
    unsigned char type;
  } names[kEntriesMax];
};

std::string UpperCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// Returns whether `entry` of the host's folder `path` is no FIFO, socket or device, and no link to
// such a file.  Also returns true for a link to a missing file.
bool IsFileOrFolder(const std::string& path, const struct dirent& entry) {
  if (entry.d_type == DT_REG || entry.d_type == DT_DIR) return true;
  std::error_code error;
  return !std::filesystem::is_other(std::filesystem::status(path + "/" + entry.d_name, error));
}

// Returns the entries of the host's folder `path`, sorted by name, because the host may list the
// entries in another order in each run.  `name` is the path that the object has used; messages to
// the user show it.  Leaves out FIFOs, sockets and devices, which no program of the robot can open
// (MemoryStick::Locate()).
std::vector<Folder::Name> ReadFolder(const std::string& path, const char* name) {
  static const auto next_open = OPENR_NEXT(opendir);
  static const auto next_read = OPENR_NEXT(readdir);
  static const auto next_close = OPENR_NEXT(closedir);
  std::vector<Folder::Name> names;
  DIR* const dir = next_open(path.c_str());
  if (dir == nullptr) return names;
  bool has_long_names = false;
  while (const struct dirent* const entry = next_read(dir)) {
    const std::string text = entry->d_name;
    const bool is_dots = text == "." || text == "..";
    if (!is_dots && !openr_host::IsShortName(text)) {
      has_long_names = true;
      continue;
    }
    if (!IsFileOrFolder(path, *entry)) continue;
    Folder::Name result = {};
    UpperCase(text).copy(result.text, sizeof result.text - 1);
    result.type = entry->d_type == DT_DIR ? DT_DIR : DT_REG;
    names.push_back(result);
  }
  next_close(dir);
  if (has_long_names) {
    t_current.system->AddFinding(
        Severity::kWarning,
        fmt::format("{}: files whose names are not 8.3 are left out of the list", name));
  }
  std::sort(names.begin(), names.end(), [](const Folder::Name& a, const Folder::Name& b) {
    return std::strcmp(a.text, b.text) < 0;
  });
  return names;
}

// Opens the folder `path` of the stick for an object.  Returns null, with errno set, if the folder
// cannot be opened.
Folder* OpenFolder(const char* path) {
  const std::string host = openr_host::HostPath(path, openr_host::StickUse::kRead);
  if (host.empty()) return nullptr;
  std::vector<Folder::Name> names;
  {
    static const auto next_open = OPENR_NEXT(opendir);
    static const auto next_close = OPENR_NEXT(closedir);
    const ApiScope scope;
    DIR* const probe = next_open(host.c_str());
    if (probe == nullptr) return nullptr;  // the folder cannot be read; next_open() has set errno
    next_close(probe);
    names = ReadFolder(host, path);
    if (names.size() > kEntriesMax) {
      t_current.system->AddFinding(
          Severity::kWarning,
          fmt::format("{}: has {} entries; readdir() shows the first {}, as on the robot", path,
                      names.size(), kEntriesMax));
      names.resize(kEntriesMax);
    }
  }
  // Calls malloc() without an ApiScope, so that the memory comes from the object's heap.  Within an
  // ApiScope, malloc() would use the host's heap.
  auto* const folder = static_cast<Folder*>(malloc(sizeof(Folder)));
  if (folder != nullptr) {
    folder->count = names.size();
    folder->next = 0;
    std::copy(names.begin(), names.end(), folder->names);
  }
  return folder;
}

// Returns the next entry of `folder`; null at its end.
struct dirent* NextEntry(Folder* folder) {
  if (folder == nullptr || folder->next >= folder->count) return nullptr;
  const Folder::Name& name = folder->names[folder->next++];
  folder->entry = {};
  folder->entry.d_type = name.type;
  folder->entry.d_reclen = sizeof folder->entry;
  std::memcpy(folder->entry.d_name, name.text, sizeof name.text);
  return &folder->entry;
}

// The function of a program that orders the entries of scandir().
using EntryOrder = int(const struct dirent**, const struct dirent**);

// Compares two entries with `order`, a pointer to a pointer to an EntryOrder.
int CompareEntries(const void* left, const void* right, void* order) {
  const struct dirent* first = *static_cast<struct dirent* const*>(left);
  const struct dirent* second = *static_cast<struct dirent* const*>(right);
  return (**static_cast<EntryOrder**>(order))(&first, &second);
}

}  // namespace

extern "C" {

DIR* opendir(const char* path) {
  static const auto next = OPENR_NEXT(opendir);
  return InObject() ? reinterpret_cast<DIR*>(OpenFolder(path)) : next(path);
}

struct dirent* readdir(DIR* dir) {
  static const auto next = OPENR_NEXT(readdir);
  return InObject() ? NextEntry(reinterpret_cast<Folder*>(dir)) : next(dir);
}

int closedir(DIR* dir) {
  static const auto next = OPENR_NEXT(closedir);
  if (!InObject()) return next(dir);
  free(dir);
  return 0;
}

// Programs that are compiled for large files call readdir64() and scandir64(), which <dirent.h>
// declares with another struct that has the same members.
static_assert(sizeof(struct dirent64) == sizeof(struct dirent));
struct dirent* OpenrReaddir64(DIR* dir) __asm__("readdir64");
struct dirent* OpenrReaddir64(DIR* dir) {
  return readdir(dir);
}

void rewinddir(DIR* dir) noexcept {
  static const auto next = OPENR_NEXT(rewinddir);
  if (!InObject()) return next(dir);
  reinterpret_cast<Folder*>(dir)->next = 0;
}

// Calls malloc() without an ApiScope, as OpenFolder() does.
int scandir(const char* path, struct dirent*** list, int (*filter)(const struct dirent*),
            EntryOrder* order) {
  static const auto next = OPENR_NEXT(scandir);
  if (!InObject()) return next(path, list, filter, order);
  Folder* const folder = OpenFolder(path);
  if (folder == nullptr) return -1;
  // Takes at least one pointer, so that malloc() does not return null for an empty folder.
  const size_t count_max = std::max<size_t>(folder->count, 1);
  auto** const entries = static_cast<struct dirent**>(malloc(count_max * sizeof(*list[0])));
  size_t count = 0;
  while (const struct dirent* const entry = entries == nullptr ? nullptr : NextEntry(folder)) {
    if (filter != nullptr && filter(entry) == 0) continue;
    entries[count] = static_cast<struct dirent*>(malloc(sizeof *entry));
    if (entries[count] == nullptr) break;
    *entries[count++] = *entry;
  }
  free(folder);
  if (entries == nullptr) return -1;  // malloc() has set errno
  if (order != nullptr) qsort_r(entries, count, sizeof *entries, &CompareEntries, &order);
  *list = entries;
  return static_cast<int>(count);
}

int OpenrScandir64(const char* path, struct dirent*** list, int (*filter)(const struct dirent*),
                   EntryOrder* order) __asm__("scandir64");
int OpenrScandir64(const char* path, struct dirent*** list, int (*filter)(const struct dirent*),
                   EntryOrder* order) {
  return scandir(path, list, filter, order);
}

}  // extern "C"
