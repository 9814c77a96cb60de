// openr build without OBJECT.CFG, and openr stick new: which images the list names that is written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/kit/kit_folder.h"
#include "tests/kit/robot_binary.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kObjects[] = "MS/OPEN-R/MW/OBJS/";
constexpr char kList[] = "MS/OPEN-R/MW/CONF/OBJECT.CFG";

// The object Greeter, and a stick without OBJECT.CFG.
class ObjectListTest : public ::testing::Test {
 protected:
  ObjectListTest() { std::filesystem::remove(folder_.File(kList)); }

  // Writes a Makefile that builds Greeter, and then has the lines `install`.
  void Install(const std::string& install) const {
    folder_.Write("Greeter/Makefile",
                  "OBJS = ../MS/OPEN-R/MW/OBJS\n"
                  "all: greeter.bin\n\tmkdir -p $(OBJS)\n" +
                      install +
                      "greeter.bin: Greeter.o GreeterEntries.o greeter.ocf\n\tmkbin -o $@ $^\n");
  }

  ProgramResult Build(const std::vector<std::string>& flags = {}) const {
    const ProgramResult built = folder_.Build(flags);
    EXPECT_EQ(built.status, 0) << built.err;
    EXPECT_THAT(built.err, HasSubstr("there is no OBJECT.CFG; one that lists every object"));
    return built;
  }

  const KitFolder folder_{"handmade"};
};

TEST_F(ObjectListTest, ImagesThatAMakefileHasCopiedAreListedUnderTheirNames) {
  Install(
      "\tcp greeter.bin $(OBJS)/HELLO.BIN\n"
      "\tcp $(OPENRSDK_ROOT)/images/POWERMON.BIN $(OBJS)/POWERMON.BIN\n");
  const ProgramResult built = Build();
  EXPECT_EQ(folder_.Read(kList), "/MS/OPEN-R/MW/OBJS/POWERMON.BIN\n/MS/OPEN-R/MW/OBJS/HELLO.BIN\n");
  EXPECT_THAT(built.out, HasSubstr("HELLO.BIN    greeter                  Makefile\n"));
  EXPECT_THAT(built.out, HasSubstr("POWERMON.BIN                          Makefile\n"));
  EXPECT_THAT(built.err, Not(HasSubstr("is not in this OBJECT.CFG")));
  EXPECT_EQ(folder_.Say(), "handmade: init\nhandmade: start\n");
}

TEST_F(ObjectListTest, OfABinaryForTheRobotTheKitsOwnIsListed) {
  folder_.Write(std::string(kObjects) + "POWERMON.BIN", RobotBinary());
  const ProgramResult built = Build();
  EXPECT_EQ(folder_.Read(kList),
            "/MS/OPEN-R/MW/OBJS/POWERMON.BIN\n/MS/OPEN-R/MW/OBJS/GREETER.BIN\n");
  EXPECT_THAT(built.out, HasSubstr("POWERMON.BIN                          the kit's own\n"));
  EXPECT_EQ(folder_.Say(), "handmade: init\nhandmade: start\n");
}

TEST_F(ObjectListTest, AnImageThatIsNotListedIsNamedWithTheReason) {
  folder_.Write(std::string(kObjects) + "WALK.BIN", RobotBinary());
  folder_.Write(std::string(kObjects) + "NOTES.BIN", "some text");
  Install(
      "\tcp greeter.bin $(OBJS)/HELLO.BIN\n"
      "\tcp greeter.bin $(OBJS)/TWICE.BIN\n"
      "\tcp $(OPENRSDK_ROOT)/images/POWERMON.BIN $(OBJS)/ALONGNAME.BIN\n");
  const ProgramResult built = Build();
  EXPECT_EQ(folder_.Read(kList), "/MS/OPEN-R/MW/OBJS/HELLO.BIN\n");
  EXPECT_THAT(built.err, HasSubstr("note: OBJS/WALK.BIN is not in this OBJECT.CFG: it is an "
                                   "image for the robot (MIPS), not for this machine\n"));
  EXPECT_THAT(built.err, HasSubstr("note: OBJS/NOTES.BIN is not in this OBJECT.CFG: it is not an "
                                   "object image"));
  EXPECT_THAT(built.err, HasSubstr("note: OBJS/TWICE.BIN is not in this OBJECT.CFG: it is an image "
                                   "of greeter, as HELLO.BIN is, which is listed\n"));
  EXPECT_THAT(built.err, HasSubstr("note: OBJS/ALONGNAME.BIN is not in this OBJECT.CFG: its name "
                                   "is not 8.3, so the robot cannot open it\n"));
}

// The user's stick has an image of a build, and the user has removed OBJECT.CFG.
TEST_F(ObjectListTest, AnImageOfAnEarlierBuildIsNotListedByItself) {
  Build();
  std::filesystem::rename(folder_.File(std::string(kObjects) + "GREETER.BIN"),
                          folder_.File(std::string(kObjects) + "OLD.BIN"));
  std::filesystem::remove(folder_.File(kList));
  const ProgramResult built = Build({"--fresh"});
  EXPECT_EQ(folder_.Read(kList), "/MS/OPEN-R/MW/OBJS/GREETER.BIN\n");
  EXPECT_THAT(built.err, HasSubstr("note: OBJS/OLD.BIN is not in this OBJECT.CFG: it is an image "
                                   "of greeter, as GREETER.BIN is, which is listed\n"));
}

TEST_F(ObjectListTest, ANewStickNamesTheImagesOfItsBaseThatNobodyLoads) {
  folder_.Write("base/OPEN-R/MW/CONF/OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/POWERMON.BIN\n");
  folder_.Write("base/OPEN-R/APERIOS.GZ", "");
  folder_.Write("base/OPEN-R/MW/OBJS/POWERMON.BIN", RobotBinary());
  folder_.Write("base/OPEN-R/MW/OBJS/TINYFTPD.BIN", RobotBinary());
  folder_.Write("HELLO.BIN", RobotBinary());
  const ProgramResult made = RunProgram({"stick", "new", "-o", folder_.File("new"), "--base",
                                         folder_.File("base"), folder_.File("HELLO.BIN")});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("OBJS/TINYFTPD.BIN of the base is not in OBJECT.CFG, so no robot "
                                  "loads it; name it among the images if it is needed\n"));
  EXPECT_THAT(made.out, Not(HasSubstr("POWERMON.BIN of the base")));
}

}  // namespace
}  // namespace openr_host
