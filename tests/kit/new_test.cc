#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

TEST(NewTest, ANewObjectBuildsAndRuns) {
  const KitFolder folder("");
  const ProgramResult made = RunProgram({"new", "Wag", folder.File("")});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("program/Wag/stub.cfg\n"));
  const ProgramResult built = folder.Build();
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_EQ(folder.Say(), "Wag has started\nWag hears 31 sensors\n");
}

TEST(NewTest, NothingIsOverwritten) {
  const KitFolder folder("");
  folder.Write("Makefile", "mine\n");
  const ProgramResult result = RunProgram({"new", "Wag", folder.File("")});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("Makefile is there already; nothing was written"));
  EXPECT_EQ(folder.Files(), std::vector<std::string>{"Makefile"});
}

TEST(NewTest, ANameThatIsNoClassIsRefused) {
  const ProgramResult result = RunProgram({"new", "9lives"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("'9lives' cannot be the name of an object"));
}

}  // namespace
}  // namespace openr_host
