// LazyLibrary: a library that is loaded when it is first needed, and errors that say what to do.
#include "runtime/base/lazy_library.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace openr_host {
namespace {

// Calls `function` of the library `file` with 2, and returns the result or the error.
std::string ResultOf(const char* file, const char* function) {
  try {
    double (*found)(double) = nullptr;
    LazyLibrary(file, "libodd, by which numbers are odd,", "libodd1").Find(&found, function);
    return std::to_string(found(2));
  } catch (const std::runtime_error& e) {
    return e.what();
  }
}

TEST(LazyLibraryTest, AFunctionCanBeCalled) {
  EXPECT_EQ(ResultOf("libm.so.6", "sqrt"), "1.414214");
}

TEST(LazyLibraryTest, AMissingLibraryIsNamedWithItsPackage) {
  const std::string error = ResultOf("libodd.so.1", "sqrt");
  EXPECT_EQ(error.find("libodd, by which numbers are odd, cannot be loaded: libodd.so.1: "), 0u)
      << error;
  EXPECT_NE(error.find("; install it (Debian package libodd1)"), std::string::npos) << error;
}

TEST(LazyLibraryTest, AMissingFunctionIsNamed) {
  EXPECT_EQ(
      ResultOf("libm.so.6", "square_of_circle"),
      "libm.so.6 is another version than the one with which this program was built: it has no "
      "square_of_circle()");
}

}  // namespace
}  // namespace openr_host
