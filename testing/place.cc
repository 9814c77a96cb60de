#include "testing/place.h"

#include <gtest/gtest.h>

namespace openr::testing {
namespace {

bool g_copy_failed = false;

}  // namespace

bool FailedFatally() { return g_copy_failed || ::testing::Test::HasFatalFailure(); }

void NoteFatalFailure() { g_copy_failed = true; }

void Fail(const Place& place, const std::string& text) {
  GTEST_MESSAGE_AT_(place.file, place.line, text.c_str(),
                    ::testing::TestPartResult::kNonFatalFailure);
}

}  // namespace openr::testing
