// Parses single lines of stub.cfg; stub_config.cc parses the whole file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"
#include "runtime/config/stub_config.h"

namespace openr_host {

enum class StubKeyword { kObjectName, kNumOfSubject, kNumOfObserver, kService, kExtra };

// A line of stub.cfg with a keyword and a colon, such as "ObjectName : Mover".
struct StubLine {
  StubKeyword keyword = StubKeyword::kService;
  std::string word;    // the keyword as written; some keywords have two spellings
  FilePosition place;  // position of `value`
  std::string value;   // the text after the colon, without blanks at both ends
};

// Splits `line` at its colon.  A line without a keyword and a colon is a comment: returns nullopt.
// Warns if the first word of such a line looks like a misspelt keyword.
std::optional<StubLine> RecognizeStubLine(const FilePosition& line,
                                          std::vector<Diagnostic>* diagnostics);

// Returns the C++ name in an ObjectName line, or "" after an error.  Ignores the rest of the line.
std::string ParseObjectName(const StubLine& line, std::vector<Diagnostic>* diagnostics);

// Returns the number in a NumOf... line, or nullopt after an error.  Ignores the rest of the line.
std::optional<int> ParseCount(const StubLine& line, std::vector<Diagnostic>* diagnostics);

// Parses a Service line.  For a line without a valid service name returns nullopt with a warning,
// because stubgen2 ignores such lines.  For a line with other errors still returns a service, so
// that the number of services is right and causes no further error.
std::optional<StubService> ParseService(const StubLine& line, std::vector<Diagnostic>* diagnostics);

// Returns the function that a line of stub.cfg such as "Extra : Name()" gives, or nullopt after an
// error.  Ignores the rest of the line.
std::optional<StubExtra> ParseExtra(const StubLine& line, std::vector<Diagnostic>* diagnostics);

}  // namespace openr_host
