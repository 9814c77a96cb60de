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
  system.inputs().OnAdd([&](int robot, std::string_view line) {
    heard += std::to_string(robot) + ":" + std::string(line);
  });
  ConsoleFeed feed(file);
  feed.Feed(&system);
  feed.Feed(&system);
  EXPECT_EQ(heard, "0:type one\ntwo1:type one\ntwo");
}

TEST(ConsoleFeedTest, AFileThatCannotBeReadIsNamed) {
  EXPECT_THROW(ConsoleFeed("/no/such/file"), std::runtime_error);
}

}  // namespace
}  // namespace openr_host
