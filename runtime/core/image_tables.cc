#include "runtime/core/image_tables.h"

#include <elf.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

namespace openr_host {
namespace {

#if defined(__aarch64__)
constexpr uint32_t kRelativeRelocation = R_AARCH64_RELATIVE;
#else
constexpr uint32_t kRelativeRelocation = R_X86_64_RELATIVE;
#endif

constexpr uint32_t kNoRelocation = 0;  // R_X86_64_NONE, R_AARCH64_NONE

constexpr uint64_t kAddressMax = uint64_t{1} << 47;

// The memory of a shared object as its file describes it.  Addresses are those of the file: the
// first segment begins at address 0, or where the object was linked.
class ImageMemory {
 public:
  explicit ImageMemory(const std::string& bytes) : bytes_(bytes) {}

  // Reads the program headers.  Returns whether the segments are in order and do not overlap.
  bool ReadSegments();
  const std::vector<Elf64_Phdr>& segments() const { return segments_; }

  // Returns whether `size` bytes at `address` are memory of a segment with the `flags` (PF_W, ...).
  bool Has(uint64_t address, uint64_t size, uint32_t flags = 0) const {
    return Find(address, size, flags, /*in_file=*/false) != nullptr;
  }

  // Returns the value of type T that the file has for `address`; nullopt if the file has none.
  template <typename T>
  std::optional<T> Read(uint64_t address) const {
    const Elf64_Phdr* const segment = Find(address, sizeof(T), 0, /*in_file=*/true);
    if (segment == nullptr) return std::nullopt;
    return ReadFile<T>(address - segment->p_vaddr + segment->p_offset);
  }

 private:
  template <typename T>
  std::optional<T> ReadFile(uint64_t offset) const {
    if (offset > bytes_.size() || sizeof(T) > bytes_.size() - offset) return std::nullopt;
    T value;
    std::memcpy(&value, bytes_.data() + offset, sizeof value);
    return value;
  }
  const Elf64_Phdr* Find(uint64_t address, uint64_t size, uint32_t flags, bool in_file) const;

  const std::string& bytes_;
  std::vector<Elf64_Phdr> segments_;
};

bool ImageMemory::ReadSegments() {
  const auto header = ReadFile<Elf64_Ehdr>(0);
  if (!header || header->e_phentsize != sizeof(Elf64_Phdr)) return false;
  uint64_t end = 0;
  for (int i = 0; i < header->e_phnum; ++i) {
    const auto segment =
        ReadFile<Elf64_Phdr>(header->e_phoff + static_cast<uint64_t>(i) * sizeof(Elf64_Phdr));
    if (!segment) return false;
    segments_.push_back(*segment);
    if (segment->p_type != PT_LOAD) continue;
    const uint64_t align = segment->p_align;
    if (segment->p_vaddr < end || segment->p_vaddr > kAddressMax ||
        segment->p_memsz > kAddressMax || segment->p_filesz > segment->p_memsz || align == 0 ||
        (align & (align - 1)) != 0 || segment->p_vaddr % align != segment->p_offset % align)
      return false;
    end = segment->p_vaddr + segment->p_memsz;
  }
  return end > 0;
}

const Elf64_Phdr* ImageMemory::Find(uint64_t address, uint64_t size, uint32_t flags,
                                    bool in_file) const {
  for (const Elf64_Phdr& segment : segments_) {
    if (segment.p_type != PT_LOAD || (segment.p_flags & flags) != flags) continue;
    const uint64_t bytes = in_file ? segment.p_filesz : segment.p_memsz;
    if (address >= segment.p_vaddr && address - segment.p_vaddr <= bytes &&
        size <= bytes - (address - segment.p_vaddr))
      return &segment;
  }
  return nullptr;
}

// The tables that the dynamic section of a shared object names.
class ImageTables {
 public:
  explicit ImageTables(const ImageMemory& memory) : memory_(memory) {}

  // Each of these functions returns whether a table is sound.  ReadDynamic() must be called first.
  bool ReadDynamic();
  bool AreTextsSound() const;
  bool AreHashesSound() const;
  bool AreVersionsSound() const;
  bool AreRelocationsSound() const;
  bool AreFunctionsSound() const;

 private:
  // Returns the value of `tag` in the dynamic section; nullopt if the section has no such tag.
  std::optional<uint64_t> Value(int64_t tag) const;
  uint64_t ValueOr0(int64_t tag) const { return Value(tag).value_or(0); }
  bool IsText(uint64_t offset) const { return offset < ValueOr0(DT_STRSZ); }
  bool IsSymbol(uint64_t index) const;
  bool IsRelocationTableSound(int64_t table, int64_t size) const;
  bool IsGnuHashSound(uint64_t address) const;
  bool IsNeededVersionSound(const Elf64_Verneed& needed, uint64_t address) const;
  bool IsArraySound(int64_t array, int64_t size) const;

  const ImageMemory& memory_;
  std::vector<Elf64_Dyn> dynamic_;
};

std::optional<uint64_t> ImageTables::Value(int64_t tag) const {
  // Takes the last of several entries with the same tag, as the dynamic linker does.
  const auto found = std::find_if(dynamic_.rbegin(), dynamic_.rend(),
                                  [tag](const Elf64_Dyn& entry) { return entry.d_tag == tag; });
  if (found == dynamic_.rend()) return std::nullopt;
  return found->d_un.d_val;
}

bool ImageTables::ReadDynamic() {
  for (const Elf64_Phdr& segment : memory_.segments()) {
    if (segment.p_type != PT_DYNAMIC) continue;
    if (!memory_.Has(segment.p_vaddr, segment.p_memsz)) return false;
    for (uint64_t at = 0; at + sizeof(Elf64_Dyn) <= segment.p_memsz; at += sizeof(Elf64_Dyn)) {
      const auto entry = memory_.Read<Elf64_Dyn>(segment.p_vaddr + at);
      if (!entry) return false;
      if (entry->d_tag == DT_NULL) {
        return ValueOr0(DT_SYMENT) == sizeof(Elf64_Sym) && Value(DT_SYMTAB) && Value(DT_STRTAB) &&
               (!Value(DT_RELA) || ValueOr0(DT_RELAENT) == sizeof(Elf64_Rela)) &&
               (!Value(DT_JMPREL) || ValueOr0(DT_PLTREL) == DT_RELA) &&
               (!Value(DT_PLTGOT) || memory_.Has(*Value(DT_PLTGOT), 3 * sizeof(uint64_t), PF_W));
      }
      dynamic_.push_back(*entry);
    }
    return false;  // the end of the section, DT_NULL, is missing
  }
  return false;
}

// Checks the table of texts, and that the names of libraries lie in this table.
bool ImageTables::AreTextsSound() const {
  const uint64_t begin = ValueOr0(DT_STRTAB), size = ValueOr0(DT_STRSZ);
  if (size == 0 || !memory_.Has(begin, size)) return false;
  if (memory_.Read<char>(begin + size - 1) != '\0') return false;
  for (const Elf64_Dyn& entry : dynamic_) {
    const bool is_text = entry.d_tag == DT_NEEDED || entry.d_tag == DT_SONAME ||
                         entry.d_tag == DT_RPATH || entry.d_tag == DT_RUNPATH ||
                         entry.d_tag == DT_AUXILIARY || entry.d_tag == DT_FILTER;
    if (is_text && !IsText(entry.d_un.d_val)) return false;
  }
  return true;
}

bool ImageTables::IsSymbol(uint64_t index) const {
  if (index > kAddressMax / sizeof(Elf64_Sym)) return false;
  const auto symbol = memory_.Read<Elf64_Sym>(ValueOr0(DT_SYMTAB) + index * sizeof(Elf64_Sym));
  return symbol && IsText(symbol->st_name);
}

// Checks the hash table with which the dynamic linker looks up symbols: a header of four words, a
// Bloom filter of `words` numbers of 64 bits, the buckets, and the chains, each of which ends at an
// odd number.
bool ImageTables::IsGnuHashSound(uint64_t address) const {
  const auto word = [&](uint64_t at) { return memory_.Read<uint32_t>(at); };
  const auto buckets = word(address), first = word(address + 4), words = word(address + 8);
  if (!buckets || !first || !words || *buckets == 0 || *words == 0 || (*words & (*words - 1)) != 0)
    return false;
  const uint64_t bucket_at = address + 16 + uint64_t{*words} * 8;
  const uint64_t chains = bucket_at + uint64_t{*buckets} * 4;
  if (!memory_.Has(address, chains - address)) return false;
  for (uint32_t i = 0; i < *buckets; ++i) {
    const auto bucket = word(bucket_at + uint64_t{i} * 4);
    if (!bucket) return false;
    if (*bucket == 0) continue;
    if (*bucket < *first) return false;
    for (uint64_t symbol = *bucket;; ++symbol) {
      const auto hash = word(chains + (symbol - *first) * 4);
      if (!hash || !IsSymbol(symbol)) return false;
      if ((*hash & 1) != 0) break;
    }
  }
  return true;
}

bool ImageTables::AreHashesSound() const {
  if (Value(DT_GNU_HASH)) return IsGnuHashSound(*Value(DT_GNU_HASH));
  if (!Value(DT_HASH)) return false;
  const uint64_t address = *Value(DT_HASH);
  const auto buckets = memory_.Read<uint32_t>(address), count = memory_.Read<uint32_t>(address + 4);
  if (!buckets || !count || *buckets == 0) return false;
  const uint64_t numbers = uint64_t{*buckets} + *count;
  if (!memory_.Has(address, 8 + numbers * 4)) return false;
  for (uint64_t i = 0; i < numbers; ++i) {
    const auto index = memory_.Read<uint32_t>(address + 8 + i * 4);
    if (!index || *index >= *count) return false;
  }
  return true;
}

// Checks the list of the versions that the image needs of one library.
bool ImageTables::IsNeededVersionSound(const Elf64_Verneed& needed, uint64_t address) const {
  uint64_t at = address + needed.vn_aux;
  for (int i = 0; i < needed.vn_cnt; ++i) {
    const auto version = memory_.Read<Elf64_Vernaux>(at);
    if (!version || !IsText(version->vna_name)) return false;
    if (version->vna_next == 0) return i + 1 == needed.vn_cnt;
    at += version->vna_next;
  }
  return false;
}

bool ImageTables::AreVersionsSound() const {
  if (!Value(DT_VERNEED)) return true;
  uint64_t at = *Value(DT_VERNEED);
  const uint64_t count = ValueOr0(DT_VERNEEDNUM);
  if (!Value(DT_VERSYM) || !memory_.Has(*Value(DT_VERSYM), sizeof(Elf64_Half))) return false;
  for (uint64_t i = 0; i < count; ++i) {
    const auto needed = memory_.Read<Elf64_Verneed>(at);
    if (!needed || needed->vn_version != VER_NEED_CURRENT || !IsText(needed->vn_file) ||
        !IsNeededVersionSound(*needed, at))
      return false;
    if (needed->vn_next == 0) return i + 1 == count;
    at += needed->vn_next;
  }
  return false;
}

bool ImageTables::IsRelocationTableSound(int64_t table, int64_t size) const {
  if (!Value(table)) return true;
  const uint64_t begin = *Value(table), bytes = ValueOr0(size);
  if (bytes % sizeof(Elf64_Rela) != 0 || !memory_.Has(begin, bytes)) return false;
  // If the image has text relocations, the dynamic linker first makes all memory of the image
  // writable.
  const bool may_be_text = Value(DT_TEXTREL) || (ValueOr0(DT_FLAGS) & DF_TEXTREL) != 0;
  const uint32_t flags = may_be_text ? 0 : PF_W;
  // The number of relocations at the beginning of the table.  These must be of the type
  // kRelativeRelocation.
  const uint64_t relative_count = table == DT_RELA ? ValueOr0(DT_RELACOUNT) : 0;
  for (uint64_t at = 0; at < bytes; at += sizeof(Elf64_Rela)) {
    const auto relocation = memory_.Read<Elf64_Rela>(begin + at);
    if (!relocation) return false;
    // Skips relocations without an effect: linkers write this type in place of the relocations of
    // code that was left out.
    if (ELF64_R_TYPE(relocation->r_info) == kNoRelocation) continue;
    if (!memory_.Has(relocation->r_offset, sizeof(uint64_t), flags) ||
        !IsSymbol(ELF64_R_SYM(relocation->r_info)))
      return false;
    if (at / sizeof(Elf64_Rela) < relative_count &&
        ELF64_R_TYPE(relocation->r_info) != kRelativeRelocation)
      return false;
  }
  return true;
}

bool ImageTables::AreRelocationsSound() const {
  return IsRelocationTableSound(DT_RELA, DT_RELASZ) &&
         IsRelocationTableSound(DT_JMPREL, DT_PLTRELSZ);
}

bool ImageTables::IsArraySound(int64_t array, int64_t size) const {
  return !Value(array) ||
         (ValueOr0(size) % sizeof(uint64_t) == 0 && memory_.Has(*Value(array), ValueOr0(size)));
}

// Checks the lists of functions that the dynamic linker calls when it loads and unloads the object.
bool ImageTables::AreFunctionsSound() const {
  for (const int64_t tag : {DT_INIT, DT_FINI}) {
    if (Value(tag) && !memory_.Has(*Value(tag), 1, PF_X)) return false;
  }
  return IsArraySound(DT_INIT_ARRAY, DT_INIT_ARRAYSZ) &&
         IsArraySound(DT_FINI_ARRAY, DT_FINI_ARRAYSZ);
}

}  // namespace

std::string DamagedTableIn(const std::string& bytes) {
  ImageMemory memory(bytes);
  if (!memory.ReadSegments()) return "the table of segments";
  ImageTables tables(memory);
  if (!tables.ReadDynamic()) return "the dynamic section";
  if (!tables.AreTextsSound()) return "the table of names";
  if (!tables.AreHashesSound()) return "the table of symbols";
  if (!tables.AreVersionsSound()) return "the table of versions";
  if (!tables.AreRelocationsSound()) return "the table of relocations";
  if (!tables.AreFunctionsSound()) return "the table of constructors";
  return "";
}

}  // namespace openr_host
