#include "cli/print_plain.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <system_error>

namespace openr_host {
namespace {

TEST(PrintPlainTest, ControlBytesOfValuesAreShownAsQuestionMarks) {
  std::FILE* const file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  PrintPlain(file, "{}: {}\n", std::string("a\x1b[2Jb\0", 7), 7);
  PrintPlainText(file, "\xc2\x9bx {}\n");
  std::rewind(file);
  char text[64];
  const size_t size = std::fread(text, 1, sizeof text, file);
  std::fclose(file);
  EXPECT_EQ(std::string(text, size), "a?[2Jb?: 7\n??x {}\n");
}

TEST(PrintPlainTest, AStreamThatFailsIsAnError) {
  std::FILE* const full = std::fopen("/dev/full", "w");
  ASSERT_NE(full, nullptr);
  std::setvbuf(full, nullptr, _IONBF, 0);
  EXPECT_THROW(PrintPlain(full, "{}\n", "text"), std::system_error);
  std::fclose(full);
}

}  // namespace
}  // namespace openr_host
