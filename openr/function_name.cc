#include "openr/function_name.h"

#include <cxxabi.h>
#include <elf.h>
#include <fcntl.h>
#include <link.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <string_view>

namespace openr_host {
namespace {

// A file in memory.  Nothing in it is believed before it was compared with the size.
class MappedFile {
 public:
  explicit MappedFile(const char* file) {
    // Not open(): that of this process may act for an object.
    const long descriptor = syscall(SYS_openat, AT_FDCWD, file, O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return;
    const long size = syscall(SYS_lseek, descriptor, 0, SEEK_END);
    void* const bytes = size <= 0 ? MAP_FAILED
                                  : mmap(nullptr, static_cast<size_t>(size), PROT_READ, MAP_PRIVATE,
                                         static_cast<int>(descriptor), 0);
    syscall(SYS_close, descriptor);
    if (bytes != MAP_FAILED) bytes_ = {static_cast<const char*>(bytes), static_cast<size_t>(size)};
  }
  ~MappedFile() {
    if (!bytes_.empty()) munmap(const_cast<char*>(bytes_.data()), bytes_.size());
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  // `count` of them from `offset` on; null when the file does not have them.
  template <typename T>
  const T* At(uint64_t offset, uint64_t count) const {
    const bool fits = offset <= bytes_.size() && count <= (bytes_.size() - offset) / sizeof(T) &&
                      offset % alignof(T) == 0;
    return fits ? reinterpret_cast<const T*>(bytes_.data() + offset) : nullptr;
  }

 private:
  std::string_view bytes_;
};

std::string Readable(const char* symbol) {
  int status = 0;
  char* const name = abi::__cxa_demangle(symbol, nullptr, nullptr, &status);
  std::string result = status == 0 ? name : symbol;
  std::free(name);
  return result;
}

// The address that a file was linked for: an image's copy is linked for the one it is loaded at.
uintptr_t AddressOf(const MappedFile& file, const ElfW(Ehdr) & header) {
  const auto* const segments = file.At<ElfW(Phdr)>(header.e_phoff, header.e_phnum);
  for (int i = 0; segments != nullptr && i < header.e_phnum; ++i) {
    if (segments[i].p_type == PT_LOAD) return segments[i].p_vaddr;
  }
  return 0;
}

std::string NameIn(const MappedFile& file, const ElfW(Shdr) & symbols, const ElfW(Shdr) & names,
                   uintptr_t offset) {
  const uint64_t count = symbols.sh_size / sizeof(ElfW(Sym));
  const auto* const table = file.At<ElfW(Sym)>(symbols.sh_offset, count);
  const char* const text = file.At<char>(names.sh_offset, names.sh_size);
  if (table == nullptr || text == nullptr || names.sh_size == 0 || text[names.sh_size - 1] != 0)
    return "";
  for (uint64_t i = 0; i < count; ++i) {
    const ElfW(Sym)& symbol = table[i];
    if (ELF64_ST_TYPE(symbol.st_info) != STT_FUNC || symbol.st_shndx == SHN_UNDEF) continue;
    if (offset < symbol.st_value || offset - symbol.st_value >= symbol.st_size) continue;
    return symbol.st_name < names.sh_size ? Readable(text + symbol.st_name) : "";
  }
  return "";
}

}  // namespace

std::string FunctionName(const char* file_name, uintptr_t offset) {
  const MappedFile file(file_name);
  const auto* const header = file.At<ElfW(Ehdr)>(0, 1);
  if (header == nullptr || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0) return "";
  const auto* const sections = file.At<ElfW(Shdr)>(header->e_shoff, header->e_shnum);
  if (sections == nullptr) return "";
  offset += AddressOf(file, *header);
  for (const uint32_t kind : {SHT_SYMTAB, SHT_DYNSYM}) {
    for (int i = 0; i < header->e_shnum; ++i) {
      const ElfW(Shdr)& section = sections[i];
      if (section.sh_type != kind || section.sh_link >= header->e_shnum) continue;
      const std::string name = NameIn(file, section, sections[section.sh_link], offset);
      if (!name.empty()) return name;
    }
  }
  return "";
}

}  // namespace openr_host
