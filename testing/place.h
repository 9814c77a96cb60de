// Place, a line in the source of a test.  A function that can fail takes a Place, so that its
// failure points to the line that called the function.
#pragma once

#include <functional>
#include <string>

namespace openr::testing {

struct Place {
  const char* file = "";
  int line = 0;

  // Returns the file and line of the call.  If Here() is the default argument of a function's
  // parameter, this is the line that calls the function, because compilers evaluate a default
  // argument where the function is called.
  static constexpr Place Here(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    return {file, line};
  }
};

// A function that reports a failure at the given line of a test, with the given text.
using ReportAt = std::function<void(const Place&, const std::string&)>;

// Adds a nonfatal failure, which points to the line `place`, to the running test.
void Fail(const Place& place, const std::string& text);

// Returns whether the running test has failed fatally, as with ASSERT_EQ().  In a copy of the
// process (RunInCopy()) GoogleTest does not know this, because failures are sent to the original
// process.  So the copy calls NoteFatalFailure() for each fatal failure.
bool FailedFatally();

// Makes FailedFatally() return true from now on.  Called in a copy of the process (RunInCopy())
// when the test has failed fatally in this copy.
void NoteFatalFailure();

}  // namespace openr::testing
