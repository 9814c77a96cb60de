#include "openr/emon/robot_code.h"

#include <elf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "runtime/base/read_file.h"
#include "runtime/core/image_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr uint32_t kLinkedAt = 0x400000;  // address at which the SDK links images

// The headers of a 32-bit ELF file that are needed to find its code.
struct Headers {
  std::optional<Elf32_Shdr> text;
  std::optional<uint32_t> gp;  // value of the register gp in the section .reginfo
  uint32_t first_load = 0;     // lowest address of a segment that is loaded
  bool has_names = false;      // true: the file has a table of symbols
};

template <typename T>
std::optional<T> ReadAt(const std::string& bytes, uint64_t at) {
  if (at > bytes.size() || sizeof(T) > bytes.size() - at) return std::nullopt;
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

// Returns the headers of the file with the bytes `bytes`; nullopt if it is no 32-bit ELF file for
// MIPS.
std::optional<Headers> HeadersIn(const std::string& bytes) {
  const auto header = ReadAt<Elf32_Ehdr>(bytes, 0);
  if (!header || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0 ||
      header->e_ident[EI_CLASS] != ELFCLASS32 || header->e_ident[EI_DATA] != ELFDATA2LSB ||
      header->e_machine != EM_MIPS)
    return std::nullopt;
  Headers result;
  result.first_load = UINT32_MAX;
  for (uint32_t i = 0; i < header->e_phnum; ++i) {
    const auto segment =
        ReadAt<Elf32_Phdr>(bytes, uint64_t{header->e_phoff} + i * sizeof(Elf32_Phdr));
    if (segment && segment->p_type == PT_LOAD)
      result.first_load = std::min(result.first_load, segment->p_vaddr);
  }
  const auto section = [&](uint32_t i) {
    return ReadAt<Elf32_Shdr>(bytes, uint64_t{header->e_shoff} + i * sizeof(Elf32_Shdr));
  };
  const auto names = section(header->e_shstrndx);
  for (uint32_t i = 0; names && i < header->e_shnum; ++i) {
    const auto here = section(i);
    if (!here) break;
    if (here->sh_type == SHT_SYMTAB) result.has_names = true;
    if (here->sh_type == SHT_MIPS_REGINFO) {
      if (const auto info = ReadAt<Elf32_RegInfo>(bytes, here->sh_offset))
        result.gp = static_cast<uint32_t>(info->ri_gp_value);
    }
    const uint64_t name = uint64_t{names->sh_offset} + here->sh_name;
    if (name < bytes.size() && bytes.compare(name, sizeof ".text", std::string(".text", 6)) == 0)
      result.text = here;
  }
  return result;
}

// Returns the address for which an image's code was linked, minus the address of the code in the
// headers of the file.
uint32_t MovedBy(const Headers& headers) {
  return headers.first_load == 0 && headers.gp.value_or(0) >= kLinkedAt ? kLinkedAt : 0;
}

}  // namespace

RobotCode::RobotCode(const fs::path& file)
    : RobotCode(file.string(), ReadFileOrThrow(file.string())) {
  if (!is_compressed_) FindNames(file);
  for (const char* const extension : {".nosnap.elf", ".elf", ".DBG"})
    FindNames(fs::path(file).replace_extension(extension));
}

RobotCode::RobotCode(const std::string& name, std::string bytes) {
  ImageFile image = CheckImage(std::move(bytes));
  bytes_ = std::move(image.bytes);
  is_compressed_ = image.is_compressed;
  ReadHeaders(name, is_compressed_ && !image.is_for_robot ? image.problem : "");
}

void RobotCode::ReadHeaders(const std::string& name, const std::string& problem) {
  if (!problem.empty()) throw std::runtime_error(fmt::format("{}: {}", name, problem));
  const std::optional<Headers> headers = HeadersIn(bytes_);
  if (!headers)
    throw std::runtime_error(fmt::format(
        "{}: is no image for the robot; give the .BIN of the robot's stick, or the ELF file from "
        "which it was made",
        name));
  if (!headers->text || headers->text->sh_type != SHT_PROGBITS || headers->gp.value_or(0) == 0)
    throw std::runtime_error(fmt::format(
        "{}: has no section {}, so it is not known where its code is; give the ELF file from which "
        "mkbin made the image",
        name, headers->gp.value_or(0) != 0 ? ".text with code" : ".reginfo"));
  moved_by_ = MovedBy(*headers);
  text_ = headers->text->sh_addr;
  text_offset_ = headers->text->sh_offset;
  text_bytes_ = headers->text->sh_size;
  file_gp_ = *headers->gp;
}

// Takes the names of functions from `file`, if it has a table of symbols and comes from the same
// build as this image, and if no file with names was found before.
void RobotCode::FindNames(const fs::path& file) {
  std::error_code error;
  if (!names_.empty() || !fs::is_regular_file(file, error)) return;
  const std::optional<Headers> headers = HeadersIn(ReadFile(file.string()).value_or(""));
  if (!headers || !headers->text || !headers->has_names || headers->gp != file_gp_) return;
  if (headers->text->sh_addr + MovedBy(*headers) != text_ + moved_by_ ||
      headers->text->sh_size != text_bytes_)
    return;
  names_ = file;
  names_moved_by_ = MovedBy(*headers);
}

bool RobotCode::Contains(uint32_t address) const {
  const uint32_t at = InFile(address);
  return at >= text_ && at - text_ < text_bytes_ && address % 4 == 0;
}

bool RobotCode::IsAfterCall(uint32_t address) const {
  // Distance in bytes from a call to its return address: the call itself, and the instruction after
  // it (delay slot), which the processor executes before the call takes effect.
  constexpr uint32_t kDelay = 8;
  if (!Contains(address) || !Contains(address - kDelay)) return false;
  const auto word =
      ReadAt<uint32_t>(bytes_, uint64_t{text_offset_} + InFile(address) - kDelay - text_);
  if (!word) return false;
  const uint32_t operation = *word >> 26;
  const bool is_jalr = operation == 0 && (*word & 63) == 9;
  const uint32_t condition = *word >> 16 & 31;
  // True for the instructions bltzal and bgezal, which are branches that call a function.
  const bool is_branch = operation == 1 && (condition == 16 || condition == 17);
  return operation == 3 || is_jalr || is_branch;  // 3 is jal, the usual call
}

CodeLookup RobotCode::LookUp(uint32_t address) const {
  if (names_.empty()) return {};
  return LookUpCode(names_.c_str(), address - loaded_by_ - names_moved_by_);
}

}  // namespace openr_host
