// The grammar of single lines of stub.cfg; stub_config.cc puts them together.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"
#include "runtime/config/stub_config.h"

namespace openr_host {

enum class StubKeyword { kObjectName, kNumOfSubject, kNumOfObserver, kService, kExtra };

// A line that counts.
struct StubLine {
  StubKeyword keyword = StubKeyword::kService;
  std::string word;    // the keyword as written: NumOfOSubject and NumOfSubject are the same
  FilePosition place;  // of what follows the colon and its blanks
  std::string value;   // what follows, trailing blanks removed
};

// nullopt when the line is ignored; warns when it looks as if it should not be.
std::optional<StubLine> RecognizeStubLine(const FilePosition& line,
                                          std::vector<Diagnostic>* diagnostics);

// The C++ name in an ObjectName line; "" after an error.  The rest of the line is ignored.
std::string ParseObjectName(const StubLine& line, std::vector<Diagnostic>* diagnostics);

// The number in a NumOf... line; -1 after an error.  The rest of the line is ignored.
int ParseCount(const StubLine& line, std::vector<Diagnostic>* diagnostics);

// A Service line.  nullopt, with a warning, when its name is not one: stubgen2 ignores such a
// line.  Errors in the rest of the line still give a service, so that counts come out right.
std::optional<StubService> ParseService(const StubLine& line, std::vector<Diagnostic>* diagnostics);

// The function of an Extra line; nullopt after an error.  The rest of the line is ignored.
std::optional<StubExtra> ParseExtra(const StubLine& line, std::vector<Diagnostic>* diagnostics);

}  // namespace openr_host
