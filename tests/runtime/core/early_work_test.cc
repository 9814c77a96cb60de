// Work of constructors while another object has the id of their image.
#include "runtime/core/early_work.h"

#include <gtest/gtest.h>

#include <new>

#include "runtime/core/code_object.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// The exception stands for a lack of memory in the middle of a reload.
TEST(EarlyWorkTest, AnExceptionGivesTheOldObjectItsNamesAndServicesBack) {
  System system;
  system.AddRobot("ERS-210", nullptr);
  Object& old = system.AddObject<CodeObject>(0, "old")->host();
  Robot& robot = system.robot(0);
  robot.names["bird"] = old.id;
  robot.directory["Old.Out.Number.S"] = {old.id, 5};
  robot.directory["Other.Out.Number.S"] = {old.id + 1, 5};
  const auto names = robot.names;
  const auto directory = robot.directory;
  CodeHost fresh(&system, old.id, 0);
  const auto load = [&] {
    EXPECT_FALSE(robot.names.contains("bird"));
    robot.names["bird"] = old.id;
    robot.names["young bird"] = old.id;
    robot.directory["Old.Out.Number.S"] = {old.id, 7};
    throw std::bad_alloc();
  };
  EXPECT_THROW(CollectEarlyWork(&fresh, &old, load), std::bad_alloc);
  EXPECT_EQ(robot.names, names);
  EXPECT_EQ(robot.directory, directory);
}

}  // namespace
}  // namespace openr_host
