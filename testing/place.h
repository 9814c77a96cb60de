// A line of a test that asked for something, so that a failure can point there.
#pragma once

#include <functional>
#include <string>

namespace openr::testing {

struct Place {
  const char* file = "";
  int line = 0;

  // Returns, when used as a default argument, the line of the test that makes the call.
  static constexpr Place Here(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    return {file, line};
  }
};

// A function that takes a failure: the line of the test, and what did not hold.
using ReportAt = std::function<void(const Place&, const std::string&)>;

// Adds a failure of the running test that points to `place`.  The test goes on.
void Fail(const Place& place, const std::string& text);

// Returns whether the running test has failed fatally.  In a copy of the process, only the part of
// the test that runs in the copy counts.
bool FailedFatally();
void NoteFatalFailure();  // called in the copy

}  // namespace openr::testing
