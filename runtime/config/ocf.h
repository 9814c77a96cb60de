// Parses an .ocf file, which describes an object: its name, stack, heap and priority.  The SDK's
// linker writes this description into the header of the object's image.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

// The length of the longest object name: oobjectNAME_MAX of <OPENR/OPENR.h>, without the closing
// NUL.
inline constexpr int kObjectNameBytesMax = 63;

// The description of an object in an .ocf file.  A file in the short form does not give all fields.
// For such a file, `module` is equal to `name`, and the other missing fields keep the defaults
// below, which are the SDK's values.  The defaults of fields that each file gives are the values of
// Sony's samples.
struct Ocf {
  std::string name;    // run-time object name, unique among all objects
  std::string module;  // equal to `name` if the file has the short form
  // The next five fields and install_selector exist only in the long form of an .ocf file.  The
  // host does not use these fields, so their words are stored and not checked.
  std::string metaspace = "mCOOP";
  std::string pic = "pic";
  std::string pid = "pid";
  std::string heap_library = "none";
  std::string same_space = "none";
  std::string install_selector = "-1";
  int64_t stack_bytes = 3072;  // the size of the stack, which never grows on the robot
  int64_t heap_bytes = 16384;  // step by which the heap grows on the robot
  // The priority of the object, 0 to 255.  The upper 4 bits are the priority class, the lower 4
  // bits are the object's share of the processor in this class.
  int priority = 128;
  bool is_cached = true;      // true for the word "cache", false for "nocache"
  bool is_translated = true;  // true for "tlb", false for "notlb"
  bool is_user_mode = true;   // true for "user", false for "kernel"
  FilePosition place;         // position of the object's name in the file
};

struct OcfResult {
  std::optional<Ocf> ocf;  // nullopt exactly if `diagnostics` has an error
  std::vector<Diagnostic> diagnostics;
};

// Parses the text of an .ocf file. '#' starts a comment anywhere in a line.  The ends of lines
// count as blanks, so the description of an object may span several lines.  The description has one
// of two forms:
//   object NAME STACK HEAP PRIORITY CACHE TLB MODE
//   object NAME MODULE METASPACE PIC PID HEAPLIB STACK HEAP SAMESPACE INSTALLSEL PRIORITY CACHE
//          TLB MODE
// Sizes are in bytes, or in units of 1024 with a suffix k or K.
OcfResult ParseOcf(const std::string& file, std::string_view text);

}  // namespace openr_host
