// Reads EMON.LOG, the record that the emergency monitor of a robot writes when a program crashes.
//
// The record has parts (field-notes.md 4.5) under headings in brackets.  Records differ, so this
// reader takes the words before a number as its name.  The reader does not need all parts, nor the
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
// Number of the register gp, which points into the data of the image whose code runs.
constexpr int kRobotGp = 28;
constexpr int kRobotSp = 29;  // number of the register sp, the stack pointer
constexpr int kRobotRa = 31;  // number of the register ra, the return address

struct EmonLog {
  // An object in the list of objects that the crash record has.
  struct Object {
    std::string name;
    uint32_t context = 0;
    uint32_t thread = 0;
    uint32_t oid = 0;
    std::string meta_space;  // the object's environment, such as mCOOP; "": not in the record
  };

  // Exception code of the processor.  If no line of the crash record has it, it is taken from the
  // register Cause.
  std::optional<uint32_t> code;
  std::optional<uint32_t> cause;        // value of the register Cause
  std::optional<uint32_t> bad_address;  // value of the register BadVAddr
  // Address of the instruction that failed.  If this instruction is in the delay slot of a branch,
  // the address of the branch.
  std::optional<uint32_t> epc;
  std::optional<uint32_t> context;  // context (a number) of the object that crashed
  std::array<std::optional<uint32_t>, kRobotRegisters> registers;
  std::vector<Object> objects;
  // Words of the stack dump; the key is the address of the word.
  std::map<uint32_t, uint32_t> stack;

  // Returns the address of the instruction that failed; nullopt if `epc` is not known.  If this
  // instruction is in the delay slot of a branch, right after the branch, then `epc` is the address
  // of the branch, and bit 31 of `cause` is set.
  std::optional<uint32_t> FailedAddress() const;

  // Returns the object that crashed: the element of `objects` with the same context as the field
  // `context`.  Returns null if there is no such element.
  const Object* CrashedObject() const;
};

// Reads the text of an EMON.LOG.  Returns nullopt if the text has neither an address of an
// instruction nor an exception code.
std::optional<EmonLog> ParseEmonLog(const std::string& text);

// Returns what the exception code `code` says about the program, such as "a division of
// integers by zero, or a breakpoint".
std::string MeaningOfException(uint32_t code);

}  // namespace openr_host
