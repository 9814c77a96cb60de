// Reads EMON.LOG, the record that the emergency monitor of a robot writes when a program crashes.
//
// The record has parts (field-notes.md 4.5) under headings in brackets.  Records differ, so this
// reader takes the words before a number as its name.  It does not need all parts, nor the
// headings.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace openr_host {

constexpr int kRobotRegisters = 32;
constexpr int kRobotGp = 28;  // points into the data of the image whose code runs
constexpr int kRobotSp = 29;  // stack pointer
constexpr int kRobotRa = 31;  // return address

struct EmonLog {
  // A line of the list of objects.
  struct Object {
    std::string name;
    uint32_t context = 0;
    uint32_t thread = 0;
    uint32_t oid = 0;
    std::string meta_space;  // "" if the line does not have it
  };

  // Exception code of the processor.  Without a line that has the code, it comes from `cause`.
  std::optional<uint32_t> code;
  std::optional<uint32_t> cause;        // register Cause
  std::optional<uint32_t> bad_address;  // register BadVAddr
  // Address of the instruction that failed, or of the branch before it.
  std::optional<uint32_t> epc;
  std::optional<uint32_t> context;  // context of the object that crashed
  std::array<std::optional<uint32_t>, kRobotRegisters> registers;
  std::vector<Object> objects;
  std::map<uint32_t, uint32_t> stack;  // words of the stack dump by their address

  // Returns the address of the instruction that failed.  If it comes right after a branch, in the
  // branch's delay slot, `epc` is the branch, and bit 31 of `cause` is set.
  std::optional<uint32_t> Failed() const;

  // Returns the object that crashed, the one with `context`; null if the log does not have it.
  const Object* Crashed() const;
};

// Reads the text of an EMON.LOG.  Returns nullopt if the text has neither an address of an
// instruction nor an exception code.
std::optional<EmonLog> ParseEmonLog(const std::string& text);

// Returns what the exception code `code` says about the program, such as "a division of
// integers by zero, or a breakpoint".
std::string MeaningOfException(uint32_t code);

}  // namespace openr_host
