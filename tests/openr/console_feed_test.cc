#include "openr/run/console_feed.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>
#include <string>

#include "runtime/base/temp_folder.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

TEST(ConsoleFeedTest, AFileIsTypedOnceOnEveryRobot) {
  const TempFolder folder;
  const std::string file = folder.path() + "/typed.txt";
  std::ofstream(file) << "one\ntwo";
  System system;
  system.AddRobot("ERS-210", nullptr);
  system.AddRobot("ERS-210", nullptr);
  std::string heard;
  system.OnConsoleInput([&](int robot, std::string_view text) {
    heard += std::to_string(robot) + ":" + std::string(text);
  });
  ConsoleFeed feed(file);
  feed.Feed(&system);
  feed.Feed(&system);
  EXPECT_EQ(heard, "0:one\ntwo\n1:one\ntwo\n");
}

TEST(ConsoleFeedTest, AFileThatCannotBeReadIsNamed) {
  EXPECT_THROW(ConsoleFeed("/no/such/file"), std::runtime_error);
}

}  // namespace
}  // namespace openr_host
