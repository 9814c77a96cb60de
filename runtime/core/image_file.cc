#include "runtime/core/image_file.h"

#include <elf.h>
#include <fmt/format.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "runtime/base/read_file.h"
#include "runtime/config/service_name.h"
#include "runtime/core/image_tables.h"
#include "runtime/stick/gzip.h"

namespace openr_host {
namespace {

constexpr char kForRobot[] =
    "is a binary for the robot (MIPS); build the object for the host (openr build)";
// The section of an image that holds its .ocf text.  The build makes this section.
constexpr char kOcfSection[] = "openr_ocf";
constexpr char kCutOff[] = "ends too early: the file was cut off; copy it again";

constexpr char kSentAsText[] =
    "was changed on its way: each line end in it is CR LF, as after a transfer of text (FTP: type "
    "A); copy it again as binary (type I)";

// Returns whether each LF of the file has a CR before it.  This shows that a transfer in text mode,
// as of FTP, has changed the file: in compressed bytes only one LF of 256 has a CR before it by
// chance, so a few LFs are enough.
bool HasLineEndsOfText(std::string_view bytes) {
  constexpr int kLineEndsMin = 4;
  int line_ends = 0;
  for (size_t at = bytes.find('\n'); at != std::string_view::npos; at = bytes.find('\n', at + 1)) {
    if (at == 0 || bytes[at - 1] != '\r') return false;
    ++line_ends;
  }
  return line_ends >= kLineEndsMin;
}

// Returns whether `bytes`, the content of an image file, have all bytes that the dynamic linker
// maps.  A file that was cut off must not be loaded, because the dynamic linker would crash.
bool IsWhole(const std::string& bytes, const Elf64_Ehdr& header) {
  for (int i = 0; i < header.e_phnum; ++i) {
    const uint64_t at = header.e_phoff + static_cast<uint64_t>(i) * sizeof(Elf64_Phdr);
    if (at > bytes.size() || sizeof(Elf64_Phdr) > bytes.size() - at) return false;
    Elf64_Phdr segment;
    std::memcpy(&segment, bytes.data() + at, sizeof segment);
    if (segment.p_type != PT_LOAD) continue;
    if (segment.p_offset > bytes.size() || segment.p_filesz > bytes.size() - segment.p_offset)
      return false;
  }
  return true;
}

std::string CheckFormat(const std::string& bytes, bool* is_for_robot) {
  Elf64_Ehdr header{};
  // The image file may be shorter than an ELF header.  Copies only the bytes that the file has; the
  // other fields of the header stay 0.
  std::memcpy(&header, bytes.data(), std::min(bytes.size(), sizeof header));
  if (bytes.size() < sizeof(Elf32_Ehdr) || std::memcmp(&header, ELFMAG, SELFMAG) != 0)
    return "is not an object image; build the object for the host (openr build)";
  // Reads e_machine from the 64-bit header even if the image file is for the robot, which has 32
  // bits, because this field has the same offset in both headers.
  *is_for_robot = header.e_machine == EM_MIPS;
  if (*is_for_robot) return kForRobot;
  if (bytes.size() < sizeof header || header.e_ident[EI_CLASS] != ELFCLASS64)
    return "is not a shared object for this machine";
  if (header.e_type != ET_DYN) return "is not a shared object";
  if (!IsWhole(bytes, header)) return kCutOff;
  const std::string table = DamagedTableIn(bytes);
  if (table.empty()) return "";
  return fmt::format(
      "is damaged: {} is wrong; copy it again, or build the object again (openr build)", table);
}

// Copies the value of type T at offset `at` of the image file into `*value`.  Returns false if the
// file is too short.
template <typename T>
bool ReadAt(const std::string& bytes, uint64_t at, T* value) {
  if (at > bytes.size() || sizeof(T) > bytes.size() - at) return false;
  std::memcpy(value, bytes.data() + at, sizeof(T));
  return true;
}

}  // namespace

std::string OcfTextOf(const std::string& bytes) {
  Elf64_Ehdr header;
  Elf64_Shdr names;
  if (!ReadAt(bytes, 0, &header)) return "";
  const auto section_at = [&](uint64_t i) { return header.e_shoff + i * sizeof(Elf64_Shdr); };
  if (!ReadAt(bytes, section_at(header.e_shstrndx), &names)) return "";
  for (uint64_t i = 0; i < header.e_shnum; ++i) {
    Elf64_Shdr section;
    if (!ReadAt(bytes, section_at(i), &section)) return "";
    const uint64_t name = names.sh_offset + section.sh_name;
    // Looks for the section kOcfSection, which holds the .ocf text.  Compares the NUL at the end of
    // the section's name too, because a longer name that only begins with kOcfSection names another
    // section.
    if (name >= bytes.size() ||
        bytes.compare(name, sizeof kOcfSection, kOcfSection, sizeof kOcfSection))
      continue;
    if (section.sh_offset > bytes.size()) return "";
    const std::string text = bytes.substr(section.sh_offset, section.sh_size);
    // Leaves out the NUL that ends the .ocf text, and all bytes of the section behind it.
    return text.substr(0, text.find('\0'));
  }
  return "";
}

std::string SanitizerOf(const std::string& bytes) {
  Elf64_Ehdr header;
  if (!ReadAt(bytes, 0, &header)) return "";
  for (uint64_t i = 0; i < header.e_shnum; ++i) {
    Elf64_Shdr section, texts;
    if (!ReadAt(bytes, header.e_shoff + i * sizeof section, &section)) return "";
    if (section.sh_type != SHT_DYNAMIC ||
        !ReadAt(bytes, header.e_shoff + section.sh_link * sizeof texts, &texts))
      continue;
    for (uint64_t at = 0; at + sizeof(Elf64_Dyn) <= section.sh_size; at += sizeof(Elf64_Dyn)) {
      Elf64_Dyn entry;
      if (!ReadAt(bytes, section.sh_offset + at, &entry)) return "";
      const uint64_t name_at = texts.sh_offset + entry.d_un.d_val;
      if (entry.d_tag != DT_NEEDED || name_at >= bytes.size()) continue;
      const std::string name(bytes, name_at, bytes.find('\0', name_at) - name_at);
      if (name.starts_with("libasan.so")) return name;
    }
  }
  return "";
}

std::vector<std::string> FunctionsIn(const std::string& bytes) {
  std::vector<std::string> names;
  Elf64_Ehdr header;
  if (!ReadAt(bytes, 0, &header)) return names;
  for (uint64_t i = 0; i < header.e_shnum; ++i) {
    Elf64_Shdr section, texts;
    if (!ReadAt(bytes, header.e_shoff + i * sizeof section, &section)) return names;
    if (section.sh_type != SHT_SYMTAB ||
        !ReadAt(bytes, header.e_shoff + section.sh_link * sizeof texts, &texts))
      continue;
    for (uint64_t at = 0; at + sizeof(Elf64_Sym) <= section.sh_size; at += sizeof(Elf64_Sym)) {
      Elf64_Sym symbol;
      if (!ReadAt(bytes, section.sh_offset + at, &symbol)) return names;
      const uint64_t name_at = texts.sh_offset + symbol.st_name;
      if (ELF64_ST_TYPE(symbol.st_info) != STT_FUNC || symbol.st_shndx == SHN_UNDEF ||
          name_at >= bytes.size())
        continue;
      names.emplace_back(bytes, name_at, bytes.find('\0', name_at) - name_at);
    }
  }
  return names;
}

ImageFile ReadImageFile(const std::string& path) {
  std::optional<std::string> bytes = ReadFile(path);
  if (bytes) return CheckImage(*std::move(bytes));
  ImageFile image;
  image.problem = errno == EISDIR ? "is no file" : "cannot be read";
  return image;
}

ImageFile CheckImage(std::string bytes) {
  ImageFile image;
  image.bytes = std::move(bytes);
  image.is_compressed = IsGzip(image.bytes);
  if (image.is_compressed) {
    std::string unpacked;
    switch (Gunzip(image.bytes, &unpacked)) {
      case GzipResult::kWhole:
        break;
      case GzipResult::kCutOff:
        image.problem = kCutOff;
        break;
      case GzipResult::kDamaged:
        image.problem =
            "is a damaged gzip file; copy it again, or build the object again (openr build)";
        break;
    }
    if (!image.problem.empty() && HasLineEndsOfText(image.bytes)) image.problem = kSentAsText;
    image.bytes = std::move(unpacked);
  }
  if (image.problem.empty()) image.problem = CheckFormat(image.bytes, &image.is_for_robot);
  return image;
}

std::vector<std::string_view> TextsIn(std::string_view bytes) {
  std::vector<std::string_view> texts;
  size_t begin = 0;
  for (size_t i = 0; i <= bytes.size(); ++i) {
    const bool is_text = i < bytes.size() && (std::isprint(static_cast<unsigned char>(bytes[i])) ||
                                              bytes[i] == '\n' || bytes[i] == '\t');
    if (is_text) continue;
    if (i - begin >= 8) texts.push_back(bytes.substr(begin, i - begin));
    begin = i + 1;
  }
  return texts;
}

std::vector<std::string> ServicesInImage(std::string_view bytes) {
  std::vector<std::string> names;
  for (const std::string_view text : TextsIn(bytes)) {
    const bool ends_so = text.ends_with(".S") || text.ends_with(".O");
    if (ends_so && text.find_first_of(" \t\n/%") == std::string_view::npos &&
        ParseServiceName(text, nullptr))
      names.emplace_back(text);
  }
  return names;
}

}  // namespace openr_host
