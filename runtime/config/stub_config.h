// stub.cfg: an object's services and entry points, from which its stub is generated.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"
#include "runtime/config/service_name.h"

namespace openr_host {

// Selectors 0..63 exist for an object of the robot; the linker's image header holds no more.
inline constexpr int kSelectorsMax = 64;

struct StubService {
  ServiceName name;
  // Member functions of the core class; "" where stub.cfg says null.
  std::string connect_function;  // subject: control event; observer: connect event
  std::string data_function;     // subject: ready event; observer: notify event
  FilePosition place;            // of the name
};

struct StubExtra {
  std::string function;
  FilePosition place;
};

// Subjects and observers are numbered independently, each in file order.
struct StubConfig {
  std::string object_name;  // C++ class of the object
  std::vector<StubService> subjects;
  std::vector<StubService> observers;
  std::vector<StubExtra> extras;
  FilePosition object_name_place;

  // 4 for the life cycle, two per service, one per extra.
  int NumOfSelectors() const;
};

struct StubConfigResult {
  StubConfig config;  // fit for GenerateStub iff !HasErrors(diagnostics)
  std::vector<Diagnostic> diagnostics;
};

// Parses the text of a stub.cfg.  A line counts if it starts, after blanks, with ObjectName,
// NumOfOSubject or NumOfSubject, NumOfOObserver or NumOfObserver, Service or Extra, and a colon;
// every other line is ignored, which is what makes "//", "#" and prose comments.  So far as in
// Sony's stubgen2, whose behaviour was observed.  Beyond it: a line that looks like a slip of the
// pen is ignored with a warning, all mistakes are reported and not only the first, and what would
// only fail in the compiler (equal constants, impossible names) is an error here.
StubConfigResult ParseStubConfig(const std::string& file, std::string_view text);

}  // namespace openr_host
