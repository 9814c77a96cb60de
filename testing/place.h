// Where in a test something was asked for, so that a failure points there.
#pragma once

#include <functional>
#include <string>

namespace openr::testing {

struct Place {
  const char* file = "";
  int line = 0;

  // As a default argument: the line of the call.
  static constexpr Place Here(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    return {file, line};
  }
};

// Gets failures: where the test asked for what did not hold, and what that is.
using ReportAt = std::function<void(const Place&, const std::string&)>;

// Adds a failure of the running test that points to `place`.  The test goes on.
void Fail(const Place& place, const std::string& text);

// Whether the running test, or the copy of the process in which a part of it runs, has failed
// fatally.
bool FailedFatally();
void NoteFatalFailure();  // of the copy

}  // namespace openr::testing
