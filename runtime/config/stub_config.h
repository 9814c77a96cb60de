// Parses stub.cfg, which lists the services and entries of an object.  The object's stub is
// generated from this list.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"
#include "runtime/config/service_name.h"

namespace openr_host {

// The largest number of entries of an object of the robot, which have selectors 0 to 63.  The
// header that the linker writes into the image of the object has no room for more.
inline constexpr int kSelectorsMax = 64;

struct StubService {
  ServiceName name;
  // Member functions of the object's class that handle the events of the service; "" where stub.cfg
  // says null.
  std::string
      connect_function;       // handles control events of a subject, connect events of an observer
  std::string data_function;  // handles ready events of a subject, notify events of an observer
  FilePosition place;         // position of the service's name in the file
};

struct StubExtra {
  std::string function;
  FilePosition place;
};

// The content of a stub.cfg.  Subjects are numbered from 0 in the order of the file.  Observers are
// numbered from 0, too.
struct StubConfig {
  std::string object_name;  // C++ class of the object
  std::vector<StubService> subjects;
  std::vector<StubService> observers;
  std::vector<StubExtra> extras;
  FilePosition object_name_place;

  // Returns the number of selectors: 4 for DoInit, DoStart, DoStop and DoDestroy, two per service
  // and one per Extra line.
  int NumOfSelectors() const;
};

struct StubConfigResult {
  StubConfig config;  // may be given to GenerateStub() if !HasErrors(diagnostics)
  std::vector<Diagnostic> diagnostics;
};

// Parses the text of a stub.cfg.  Reads the lines that start, after blanks, with ObjectName,
// NumOfOSubject or NumOfSubject, NumOfOObserver or NumOfObserver, Service or Extra, and a colon.
// Ignores every other line, so "//", "#" and plain text are comments.  Sony's stubgen2 was observed
// to do all this.  Unlike stubgen2, this parser reports all mistakes and not only the first, and
// warns about an ignored line that looks like a typing error.  It also reports errors that
// otherwise only the compiler of the stub would find (equal constants, impossible names).
StubConfigResult ParseStubConfig(const std::string& file, std::string_view text);

}  // namespace openr_host
