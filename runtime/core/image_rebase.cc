#include "runtime/core/image_rebase.h"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

// Two types of relocations.  A relocation is a place in the image that the loader fills in with an
// address.  With these two types the address depends on the addend, a number in the relocation that
// is itself an address in the image.  So moving the image changes the addend.
#if defined(__aarch64__)
constexpr uint32_t kRelative = R_AARCH64_RELATIVE, kIndirect = R_AARCH64_IRELATIVE;
#else
constexpr uint32_t kRelative = R_X86_64_RELATIVE, kIndirect = R_X86_64_IRELATIVE;
#endif

// HoldConstructors() puts these tags into the dynamic section of an image, in place of
// DT_INIT_ARRAY and DT_INIT_ARRAYSZ, which name the constructors of the image's global objects.
// Because the loader ignores unknown tags, it does not run the constructors.
constexpr int64_t kHeldArray = 0x60006f70, kHeldArraySize = 0x60006f71;

// Returns whether the value of an entry with this `tag` in the dynamic section of an image is an
// address in the image, which moves with the image.
bool IsAddress(int64_t tag) {
  switch (tag) {
    case DT_PLTGOT:
    case DT_HASH:
    case DT_STRTAB:
    case DT_SYMTAB:
    case DT_RELA:
    case DT_INIT:
    case DT_FINI:
    case DT_JMPREL:
    case DT_INIT_ARRAY:
    case kHeldArray:
    case DT_FINI_ARRAY:
    case DT_PREINIT_ARRAY:
    case DT_VERSYM:
    case DT_VERDEF:
    case DT_VERNEED:
      return true;
    default:
      return tag >= DT_ADDRRNGLO && tag <= DT_ADDRRNGHI;
  }
}

// Finds all words of an image file that hold addresses in the image.  A word has 8 bytes.
class AddressWords {
 public:
  explicit AddressWords(std::string* bytes) : bytes_(*bytes) {}

  // Returns whether the words are found.  Fails if `bytes` are not a shared object for this
  // processor, if it was not linked for address 0, or if it needs more than `size_max` bytes of
  // memory.
  bool Find(uint64_t size_max);

  // Adds `distance` to each word that Find() has found.
  void Add(uint64_t distance);

 private:
  // Returns the address in bytes_ of `count` values of type T at `offset` of the image file.  If
  // the file is too short, returns null and sets is_bad_.
  template <typename T>
  T* At(uint64_t offset, uint64_t count);
  // Returns the offset in the image file of the bytes that are loaded at `address`.  If the file
  // has no such bytes, returns 0 and sets is_bad_.
  uint64_t OffsetOf(uint64_t address);
  uint64_t ValueOf(int64_t tag) const;
  void FindInSegments(const Elf64_Ehdr& header);
  void FindInSymbols(const Elf64_Ehdr& header);
  void FindInRelocations(int64_t table, int64_t size);

  std::string& bytes_;
  std::span<Elf64_Phdr> segments_;  // the program headers
  std::span<Elf64_Dyn> dynamic_;    // the dynamic section
  std::vector<uint64_t*> words_;
  bool is_bad_ = false;
};

template <typename T>
T* AddressWords::At(uint64_t offset, uint64_t count) {
  if (offset > bytes_.size() || count > (bytes_.size() - offset) / sizeof(T) ||
      offset % alignof(T) != 0) {
    is_bad_ = true;
    return nullptr;
  }
  return reinterpret_cast<T*>(bytes_.data() + offset);
}

uint64_t AddressWords::OffsetOf(uint64_t address) {
  for (const Elf64_Phdr& segment : segments_) {
    if (segment.p_type == PT_LOAD && address >= segment.p_vaddr &&
        address - segment.p_vaddr < segment.p_filesz)
      return address - segment.p_vaddr + segment.p_offset;
  }
  is_bad_ = true;
  return 0;
}

uint64_t AddressWords::ValueOf(int64_t tag) const {
  const auto found = std::find_if(dynamic_.begin(), dynamic_.end(),
                                  [tag](const Elf64_Dyn& entry) { return entry.d_tag == tag; });
  return found == dynamic_.end() ? 0 : found->d_un.d_val;
}

// Sets segments_ and dynamic_, and finds the words with addresses in both.
void AddressWords::FindInSegments(const Elf64_Ehdr& header) {
  auto* const segments = At<Elf64_Phdr>(header.e_phoff, header.e_phnum);
  if (segments == nullptr) return;
  segments_ = {segments, header.e_phnum};
  for (Elf64_Phdr& segment : segments_) {
    // Leaves out the segment PT_GNU_STACK, because it has no address: it only tells whether stacks
    // may hold code.
    if (segment.p_type == PT_GNU_STACK) continue;
    words_.push_back(&segment.p_vaddr);
    words_.push_back(&segment.p_paddr);
    if (segment.p_type != PT_DYNAMIC) continue;
    const uint64_t count = segment.p_filesz / sizeof(Elf64_Dyn);
    auto* const entries = At<Elf64_Dyn>(segment.p_offset, count);
    if (entries == nullptr) return;
    dynamic_ = {entries, count};
  }
  for (Elf64_Dyn& entry : dynamic_) {
    if (IsAddress(entry.d_tag)) words_.push_back(&entry.d_un.d_ptr);
  }
}

// Finds the values of the dynamic symbols, which are addresses of functions and variables of the
// image.  Leaves out symbols of other libraries, of constants and of thread-local variables,
// because their values are no addresses in the image.  Leaves out all other tables of symbols,
// because the loader does not read them.  The number of the dynamic symbols is in the header of
// their section.
void AddressWords::FindInSymbols(const Elf64_Ehdr& header) {
  const auto* const sections = At<Elf64_Shdr>(header.e_shoff, header.e_shnum);
  bool has_symbols = false;
  for (int i = 0; sections != nullptr && i < header.e_shnum; ++i) {
    if (sections[i].sh_type != SHT_DYNSYM) continue;
    has_symbols = true;
    const uint64_t count = sections[i].sh_size / sizeof(Elf64_Sym);
    auto* const symbols = At<Elf64_Sym>(sections[i].sh_offset, count);
    for (uint64_t s = 0; symbols != nullptr && s < count; ++s) {
      Elf64_Sym& symbol = symbols[s];
      if (symbol.st_shndx == SHN_UNDEF || symbol.st_shndx == SHN_ABS ||
          symbol.st_shndx == SHN_COMMON || ELF64_ST_TYPE(symbol.st_info) == STT_TLS)
        continue;
      words_.push_back(&symbol.st_value);
    }
  }
  if (!has_symbols) is_bad_ = true;
}

void AddressWords::FindInRelocations(int64_t table, int64_t size) {
  const uint64_t address = ValueOf(table);
  if (address == 0) return;
  const uint64_t count = ValueOf(size) / sizeof(Elf64_Rela);
  auto* const relocations = At<Elf64_Rela>(OffsetOf(address), count);
  if (relocations == nullptr) return;
  for (uint64_t i = 0; i < count; ++i) {
    words_.push_back(&relocations[i].r_offset);
    const uint64_t type = ELF64_R_TYPE(relocations[i].r_info);
    if (type == kRelative || type == kIndirect)
      words_.push_back(reinterpret_cast<uint64_t*>(&relocations[i].r_addend));
  }
}

bool AddressWords::Find(uint64_t size_max) {
  const auto* const header = At<Elf64_Ehdr>(0, 1);
  if (header == nullptr || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0 ||
      header->e_ident[EI_CLASS] != ELFCLASS64 || header->e_type != ET_DYN)
    return false;
  FindInSegments(*header);
  uint64_t end = 0;
  for (const Elf64_Phdr& segment : segments_) {
    if (segment.p_type != PT_LOAD) continue;
    if (end == 0 && segment.p_vaddr != 0) return false;  // was linked for an address other than 0
    end = std::max(end, segment.p_vaddr + segment.p_memsz);
  }
  // Relocations in the formats REL and RELR are not supported.  Images do not have them, because
  // the linkers of Debian write the format RELA for this processor.
  const bool is_strange = ValueOf(DT_REL) != 0 || ValueOf(DT_RELR) != 0;
  if (is_bad_ || end > size_max || is_strange) return false;
  FindInRelocations(DT_RELA, DT_RELASZ);
  if (ValueOf(DT_PLTREL) == DT_RELA) FindInRelocations(DT_JMPREL, DT_PLTRELSZ);
  FindInSymbols(*header);
  return !is_bad_;
}

void AddressWords::Add(uint64_t distance) {
  for (uint64_t* const word : words_) *word += distance;
}

}  // namespace

bool RebaseImage(std::string* bytes, uint64_t address, uint64_t size_max) {
  ASSERT(address % 65536 == 0, "address {:#x}", address);
  AddressWords words(bytes);
  if (!words.Find(size_max)) return false;
  words.Add(address);
  return true;
}

namespace {

// Returns the entries of the dynamic section of the shared object `bytes`; no entries if `bytes`
// are no shared object of this processor.
std::span<Elf64_Dyn> DynamicEntries(std::string* bytes) {
  const auto has = [bytes](uint64_t offset, uint64_t size) {
    return offset <= bytes->size() && size <= bytes->size() - offset && offset % 8 == 0;
  };
  if (!has(0, sizeof(Elf64_Ehdr)) || std::memcmp(bytes->data(), ELFMAG, SELFMAG) != 0) return {};
  const auto* const header = reinterpret_cast<const Elf64_Ehdr*>(bytes->data());
  if (header->e_ident[EI_CLASS] != ELFCLASS64 ||
      !has(header->e_phoff, header->e_phnum * sizeof(Elf64_Phdr)))
    return {};
  const auto* const segments = reinterpret_cast<const Elf64_Phdr*>(bytes->data() + header->e_phoff);
  for (int i = 0; i < header->e_phnum; ++i) {
    const Elf64_Phdr& segment = segments[i];
    if (segment.p_type != PT_DYNAMIC || !has(segment.p_offset, segment.p_filesz)) continue;
    return {reinterpret_cast<Elf64_Dyn*>(bytes->data() + segment.p_offset),
            segment.p_filesz / sizeof(Elf64_Dyn)};
  }
  return {};
}

}  // namespace

void HoldConstructors(std::string* bytes) {
  for (Elf64_Dyn& entry : DynamicEntries(bytes)) {
    if (entry.d_tag == DT_INIT_ARRAY) entry.d_tag = kHeldArray;
    if (entry.d_tag == DT_INIT_ARRAYSZ) entry.d_tag = kHeldArraySize;
  }
}

void DropDestructors(std::string* bytes) {
  for (Elf64_Dyn& entry : DynamicEntries(bytes)) {
    // Keeps an array of one function, because this function belongs to the start code that the
    // compiler adds to each image.  The function would call the destructors that objects have
    // registered, and objects can register none (process_hooks.cc).
    if (entry.d_tag != DT_FINI_ARRAYSZ || entry.d_un.d_val <= sizeof(void (*)())) continue;
    // The destructor that openr build --coverage adds writes the counts to a file *.gcda.
    if (bytes->find(".gcda") == std::string::npos) entry.d_un.d_val = 0;
  }
}

std::vector<void (*)()> HeldConstructors(void* handle) {
  link_map* map = nullptr;
  if (dlinfo(handle, RTLD_DI_LINKMAP, &map) != 0) return {};
  uint64_t address = 0, bytes = 0;
  for (const ElfW(Dyn)* entry = map->l_ld; entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == kHeldArray) address = map->l_addr + entry->d_un.d_ptr;
    if (entry->d_tag == kHeldArraySize) bytes = entry->d_un.d_val;
  }
  const auto* const array = reinterpret_cast<void (*const*)()>(address);
  return {array, array + bytes / sizeof *array};
}

}  // namespace openr_host
