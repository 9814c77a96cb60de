// A binary for the robot's processor, for tests of what the kit says of such files.
#pragma once

#include <elf.h>

#include <cstring>
#include <string>

namespace openr_host {

// Returns the beginning of an object file for MIPS.
inline std::string RobotBinary() {
  Elf32_Ehdr header{};
  std::memcpy(header.e_ident, ELFMAG, SELFMAG);
  header.e_ident[EI_CLASS] = ELFCLASS32;
  header.e_type = ET_REL;
  header.e_machine = EM_MIPS;
  return std::string(reinterpret_cast<const char*>(&header), sizeof header) + std::string(64, 'x');
}

}  // namespace openr_host
