// Finds the function and the source line for an address in the code of an image for the robot
// (MIPS).  Such addresses stand in the crash records of the robot.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "openr/ending/code_lookup.h"

namespace openr_host {

class RobotCode {
 public:
  // Reads the image `file`: an ELF file, or a .BIN, which may be compressed.  A .BIN has no names
  // of functions; they come from a file of the same build beside it, with the same name and the
  // extension .nosnap.elf, .elf or .DBG.  Throws std::runtime_error "FILE: reason" if the file
  // cannot be read or is no image for the robot.
  explicit RobotCode(const std::filesystem::path& file);
  // Reads an image from its bytes, without names of functions.  `name` is for the error message.
  RobotCode(const std::string& name, std::string bytes);

  // Tells this object where the robot had loaded the image.  `gp` is the value of the register gp
  // while code of the image ran.  The file has the value of gp for the addresses in the file
  // (file_gp_), so the difference is the distance by which the robot has moved the code.
  void SetGp(uint32_t gp) { loaded_by_ = gp - file_gp_; }

  // Returns whether `address`, an address in the robot's memory, is in the code of this image.
  // REQUIRES: SetGp() was called.
  bool Contains(uint32_t address) const;
  // Returns whether the instruction at `address` - 8 is a call, so that `address` may be a return
  // address.  The instruction at `address` - 4, the delay slot, runs before the call takes effect.
  bool IsAfterCall(uint32_t address) const;
  // Returns the function and the source line of the instruction at `address` in the robot's memory.
  CodeLookup LookUp(uint32_t address) const;
  // Converts the robot's address `address` to the address in the file, which disassemblers print.
  uint32_t InFile(uint32_t address) const { return address - loaded_by_ - moved_by_; }

  // The file with the names of this image's functions and lines; empty if none was found.
  const std::filesystem::path& names() const { return names_; }

 private:
  void ReadHeaders(const std::string& name, const std::string& problem);
  void FindNames(const std::filesystem::path& file);

  std::string bytes_;  // bytes of the image, decompressed
  bool is_compressed_ = false;
  std::filesystem::path names_;
  // The address for which the code was linked, minus the address of the code in the headers of the
  // file names_, which has the names of the functions.
  uint32_t names_moved_by_ = 0;
  uint32_t text_ = 0;         // address of the code, as the headers of the file give it
  uint32_t text_offset_ = 0;  // place of the code's first byte in bytes_
  uint32_t text_bytes_ = 0;
  uint32_t file_gp_ = 0;  // value of the register gp that belongs to the addresses in the file
  // The address for which the code was linked, minus its address in the headers.  This difference
  // is 0 except for a .BIN, which was linked at 0x400000, and of which only the headers were moved
  // to 0 (binary.md 1.5).
  uint32_t moved_by_ = 0;
  uint32_t loaded_by_ = 0;  // distance by which the robot has moved the code when it loaded it
};

}  // namespace openr_host
