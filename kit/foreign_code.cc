#include "kit/foreign_code.h"

#include <elf.h>
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>

#include "kit/text_files.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kArchiveMark = "!<arch>\n";
// Size in bytes of the header of a member of an archive: 16 for the name, 32 for four numbers, 10
// for the size, 2 for the end mark.
constexpr size_t kMemberHeaderSize = 60;

// Returns the ELF machine number of this host.
unsigned HostMachine() {
#if defined(__x86_64__)
  return EM_X86_64;
#elif defined(__aarch64__)
  return EM_AARCH64;
#else
  return EM_NONE;
#endif
}

// Returns the name of the processor in the header of the ELF file `bytes`; "" if it is the host's
// processor or if this is no ELF file.  Files of 32 and 64 bits have the number of the processor at
// the same offset.
std::string ForeignProcessorOfElf(std::string_view bytes) {
  constexpr size_t kMachineAt = offsetof(Elf32_Ehdr, e_machine);
  if (bytes.size() < kMachineAt + 2 || !bytes.starts_with(std::string_view(ELFMAG, SELFMAG)))
    return "";
  const auto low = static_cast<unsigned char>(bytes[kMachineAt]);
  const auto high = static_cast<unsigned char>(bytes[kMachineAt + 1]);
  const bool is_big_endian = bytes[EI_DATA] == ELFDATA2MSB;
  const unsigned machine = is_big_endian ? low * 256u + high : high * 256u + low;
  if (machine == HostMachine()) return "";
  switch (machine) {
    case EM_MIPS:
    case EM_MIPS_RS3_LE:
      return "MIPS";
    case EM_386:
      return "x86 of 32 bits";
    case EM_X86_64:
      return "x86-64";
    case EM_ARM:
      return "ARM";
    case EM_AARCH64:
      return "ARM of 64 bits";
    case EM_PPC:
      return "PowerPC";
    default:
      return fmt::format("ELF machine {}", machine);
  }
}

struct Member {
  std::string name;  // name in the header of the member, without blanks at the end
  std::string_view bytes;
};

std::vector<Member> MembersOf(std::string_view archive) {
  std::vector<Member> members;
  if (!archive.starts_with(kArchiveMark)) return members;
  for (size_t at = kArchiveMark.size(); at + kMemberHeaderSize <= archive.size();) {
    std::string name(archive.substr(at, 16));
    name.erase(name.find_last_not_of(' ') + 1);
    const std::string digits(archive.substr(at + 48, 10));
    const size_t size = std::strtoul(digits.c_str(), nullptr, 10);
    at += kMemberHeaderSize;
    members.push_back({name, archive.substr(at, size)});
    // Skips a padding byte, because each member of an archive (ar) begins at an even position.
    at += size + size % 2;
  }
  return members;
}

}  // namespace

std::string ForeignProcessorOf(const fs::path& file) {
  constexpr size_t kBeginBytes = 64;
  std::string begin;
  FileReader reader(file);
  if (!reader.is_open() || !reader.Read(kBeginBytes, &begin)) return "";
  if (!begin.starts_with(kArchiveMark)) return ForeignProcessorOfElf(begin);
  const std::string archive = ReadText(file).value_or("");
  for (const Member& member : MembersOf(archive)) {
    const std::string processor = ForeignProcessorOfElf(member.bytes);
    if (!processor.empty()) return processor;
  }
  return "";
}

std::vector<std::string> ArchiveMembers(const fs::path& file) {
  std::vector<std::string> names;
  const std::string archive = ReadText(file).value_or("");
  std::string_view long_names;
  for (const Member& member : MembersOf(archive)) {
    if (member.name == "//") {
      long_names = member.bytes;
    } else if (member.name.size() > 1 && member.name[0] == '/') {
      // Looks up the name of a member of the archive, such as "/12", which stands for the name at
      // offset 12 in the archive's list of long names.
      const size_t at = std::strtoul(member.name.c_str() + 1, nullptr, 10);
      if (at < long_names.size())
        names.emplace_back(long_names.substr(at, long_names.find('/', at) - at));
    } else if (member.name != "/") {
      names.push_back(member.name.substr(0, member.name.rfind('/')));
    }
  }
  return names;
}

}  // namespace openr_host
