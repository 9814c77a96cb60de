#include "runtime/core/image.h"

#include <dlfcn.h>
#include <elf.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "runtime/config/ocf.h"
#include "runtime/core/assert.h"
#include "runtime/core/system.h"

// Called by every image before its first and after its last constructor
// (cmake/ImageInfo.cmake): they are code of the object, while the loader around them
// is not.
extern "C" void openr_image_constructors(int begin) {
  openr_host::Current& current = openr_host::t_current;
  current.image_code = begin != 0 && current.object != nullptr && current.object->is_image;
}

#if defined(__SANITIZE_ADDRESS__)
// An object's heap is freed with it, and objects rely on that; only here, where they
// use the host's, nobody does.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:openr_host::ImageObject::Dispatch\nleak:openr_host::ImageObject::Load\n";
}
#endif

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr char kFolderPrefix[] = "openr-host-run-";
constexpr size_t kSelectorMax = 64;  // entries of an object on the robot

// Removes run folders of processes that are gone.
void RemoveStaleFolders(const fs::path& parent) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(parent, error)) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(kFolderPrefix)) continue;
    const int pid = std::atoi(name.c_str() + sizeof kFolderPrefix - 1);
    if (pid > 0 && kill(pid, 0) != 0 && errno == ESRCH) fs::remove_all(entry.path(), error);
  }
}

// Whether everything the loader maps is there; it dies of a file that was cut off.
bool IsWhole(std::ifstream* stream, const Elf64_Ehdr& header) {
  stream->clear();
  stream->seekg(0, std::ios::end);
  const auto size = static_cast<uint64_t>(stream->tellg());
  for (int i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment{};
    stream->seekg(
        static_cast<std::streamoff>(header.e_phoff + static_cast<uint64_t>(i) * sizeof segment));
    if (!stream->read(reinterpret_cast<char*>(&segment), sizeof segment)) return false;
    if (segment.p_type != PT_LOAD) continue;
    if (segment.p_offset > size || segment.p_filesz > size - segment.p_offset) return false;
  }
  return true;
}

// What kind of file this is, if it is not an image for this machine.
std::string CheckFormat(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  Elf64_Ehdr header{};
  stream.read(reinterpret_cast<char*>(&header), sizeof header);
  const auto got = static_cast<size_t>(stream.gcount());
  const auto* const bytes = reinterpret_cast<const unsigned char*>(&header);
  if (got >= 2 && bytes[0] == 0x1f && bytes[1] == 0x8b) {
    return "is gzip-compressed, as binaries for the robot are; build the object for the host "
           "(openr_add_object)";
  }
  if (got < sizeof header || std::memcmp(bytes, ELFMAG, SELFMAG) != 0)
    return "is not an object image";
  if (header.e_machine == EM_MIPS) {
    return "is a binary for the robot (MIPS); build the object for the host (openr_add_object)";
  }
  if (header.e_type != ET_DYN) return "is not a shared object";
  return IsWhole(&stream, header) ? "" : "ends too early: the file was cut off; copy it again";
}

}  // namespace

RunFolder::RunFolder() {
  std::error_code error;
  fs::path parent = fs::temp_directory_path(error);
  if (error) parent = ".";
  RemoveStaleFolders(parent);
  std::string name = (parent / fmt::format("{}{}-XXXXXX", kFolderPrefix, getpid())).string();
  if (mkdtemp(name.data()) != nullptr) path_ = name;
}

RunFolder::~RunFolder() {
  std::error_code error;
  if (!path_.empty()) fs::remove_all(path_, error);
}

std::string RunFolder::AddCopy(const std::string& file) {
  if (path_.empty()) return "";
  const fs::path source(file);
  const fs::path folder = fs::path(path_) / std::to_string(copies_++);
  std::error_code error;
  fs::create_directory(folder, error);
  const fs::path copy = folder / source.filename();
  if (!fs::copy_file(source, copy, error)) return "";
  const fs::path debug = fs::path(source).replace_extension(".DBG");
  if (fs::exists(debug, error))
    fs::create_symlink(fs::absolute(debug), folder / debug.filename(), error);
  return copy;
}

ImageObject::~ImageObject() {
  for (std::FILE* file : open_files) std::fclose(file);
  const CurrentScope scope(system, this);
  if (handle_ != nullptr) dlclose(handle_);
}

std::string ImageObject::Load(const std::string& file, RunFolder* folder) {
  is_image = true;
  const std::string problem = CheckFormat(file);
  if (!problem.empty()) return problem;
  const std::string copy = folder->AddCopy(file);
  if (copy.empty()) return "cannot be copied into the run folder (disk full?)";
#if !defined(__SANITIZE_ADDRESS__)
  arena = std::make_unique<Arena>(&system->robot(robot).memory);
#endif
  {
    const CurrentScope scope(system, this);
    handle_ = dlopen(copy.c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  if (handle_ == nullptr) return fmt::format("cannot be loaded: {}", dlerror());
  return ReadTables();
}

std::string ImageObject::ReadTables() {
  const auto* const info = static_cast<const ImageInfo*>(dlsym(handle_, "openr_image_info"));
  const auto* const table = static_cast<const ObjectEntry*>(dlsym(handle_, "ObjectEntryTable"));
  if (info == nullptr || table == nullptr) {
    return fmt::format("has no {}; build it with openr_add_object",
                       table == nullptr ? "ObjectEntryTable" : "openr_image_info");
  }
  if (info->version != kImageVersion) {
    return fmt::format(
        "was built for version {} of the image format, this is version {}; build it again",
        info->version, kImageVersion);
  }
  for (const ObjectEntry* entry = table; entry->selector != UNDEF; ++entry) {
    if (entry->selector >= kSelectorMax) {
      return fmt::format("ContextManager::InitObjectEntry selector out of range: sel={}, size={}",
                         entry->selector, kSelectorMax);
    }
    if (entry->selector >= entries_.size()) entries_.resize(entry->selector + 1, nullptr);
    entries_[entry->selector] = entry->entry;
  }
  const OcfResult ocf = ParseOcf(path + " (.ocf)", info->ocf);
  if (!ocf.ocf) return "has a bad .ocf text: " + Render(ocf.diagnostics);
  name = ocf.ocf->name;
  limits.priority = ocf.ocf->priority;
  limits.stack_bytes = static_cast<uint32_t>(ocf.ocf->stack_bytes);
  limits.heap_bytes = static_cast<uint32_t>(ocf.ocf->heap_bytes);
  const auto* extras = static_cast<const char* const*>(dlsym(handle_, "openr_extra_names"));
  int extra_count = 0;
  while (extras != nullptr && extras[extra_count] != nullptr) ++extra_count;
  // Extras come last in the table (SDK reference, section 1.3).
  const auto first_extra =
      static_cast<uint32_t>(entries_.size()) - static_cast<uint32_t>(extra_count);
  for (int i = 0; i < extra_count; ++i)
    entry_names[first_extra + static_cast<uint32_t>(i)] = extras[i];
  return "";
}

bool ImageObject::Dispatch(uint32_t selector, void* payload) {
  if (selector >= entries_.size() || entries_[selector] == nullptr) return false;
  reinterpret_cast<void (*)(void*)>(entries_[selector])(payload);
  return true;
}

}  // namespace openr_host
