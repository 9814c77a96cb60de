// .ocf: the one-record description from which the SDK's linker makes an object's image header.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

// oobjectNAME_MAX of <OPENR/OPENR.h>, without the closing NUL.
inline constexpr int kObjectNameBytesMax = 63;

// Defaults are what the short form stands for, and the values of Sony's samples.
struct Ocf {
  std::string name;                 // run-time object name, unique among all objects
  std::string module;               // the name again in the short form
  std::string metaspace = "mCOOP";  // these five and install_selector: long form only,
  std::string pic = "pic";          // kept as written, without meaning for the host
  std::string pid = "pid";
  std::string heap_library = "none";
  std::string same_space = "none";
  std::string install_selector = "-1";
  int64_t stack_bytes = 3072;  // fixed size on the robot
  int64_t heap_bytes = 16384;  // step by which the heap grows on the robot
  int priority = 128;          // 0..255; upper 4 bits class, lower 4 share inside the class
  bool is_cached = true;       // "cache"
  bool is_translated = true;   // "tlb"
  bool is_user_mode = true;    // "user", not "kernel"
  FilePosition place;          // of the name
};

struct OcfResult {
  std::optional<Ocf> ocf;  // nullopt iff diagnostics hold an error
  std::vector<Diagnostic> diagnostics;
};

// Parses the text of an .ocf file.  '#' starts a comment anywhere and line ends are blanks, so the
// record may span lines:
//   object NAME STACK HEAP PRIORITY CACHE TLB MODE
//   object NAME MODULE METASPACE PIC PID HEAPLIB STACK HEAP SAMESPACE INSTALLSEL PRIORITY CACHE
//          TLB MODE
// Sizes are in bytes, or in units of 1024 with a suffix k or K.
OcfResult ParseOcf(const std::string& file, std::string_view text);

}  // namespace openr_host
