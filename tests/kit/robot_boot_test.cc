// openr stick check, new and wlan: sticks for a real robot.
#include <gmock/gmock.h>
#include <zlib.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// An image for the robot, as far as its header tells.
std::string RobotImage() {
  return std::string(
             "\x7f"
             "ELF\1\1\1",
             7) +
         std::string(9, '\0') + std::string("\2\0\x8\0\1\0\0\0", 8) + std::string(200, '\0');
}

// A stick with what a base image has (measured.md 4); the files themselves are empty.
class RobotStickCheckTest : public ::testing::Test {
 protected:
  void MakeBase(bool has_network = true) {
    for (const char* file : {"APERIOS.GZ", "APERINIT.GZ", "BOOTPARA", "VERSION.txt",
                             "SYSTEM/VERSION", "SYSTEM/CONF/OBJECT.CFG", "SYSTEM/CONF/EXTOBJ.CFG",
                             "SYSTEM/CONF/EMON.CFG", "MW/CONF/CONNECT.CFG"})
      folder_.Write(std::string("stick/OPEN-R/") + file, "");
    folder_.Write("stick/OPEN-R/MW/CONF/DESIGN.CFG", "[ERS-210]\n0001.0001.*-6\n");
    for (const char* name :
         {"POWERMGR", "SRVCMGR", "VR", "DR", "SYSLOG", "VRCOMM", "VRAUCOMM", "EMGCYMON"})
      folder_.Write(std::string("stick/OPEN-R/SYSTEM/OBJS/") + name + ".BIN", "");
    if (has_network) {
      for (const char* name : {"IPSTACK", "WLANDRV", "WLANENBL", "NETCONFS"})
        folder_.Write(std::string("stick/OPEN-R/SYSTEM/OBJS/") + name + ".BIN", "");
    }
    folder_.Write("stick/OPEN-R/MW/CONF/OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/POWERMON.BIN\n");
    folder_.Write("stick/OPEN-R/MW/OBJS/POWERMON.BIN", RobotImage());
  }

  // Compresses the image of the stick; `mode` is that of gzopen(), which has the flag of gzip.
  void PackImage(const char* mode) const {
    const std::string image = RobotImage();
    const gzFile file = gzopen(folder_.File("stick/OPEN-R/MW/OBJS/POWERMON.BIN").c_str(), mode);
    EXPECT_EQ(gzwrite(file, image.data(), static_cast<unsigned>(image.size())),
              static_cast<int>(image.size()));
    gzclose(file);
  }

  ProgramResult Check(std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"stick", "check", folder_.File("stick")};
    words.insert(words.end(), more.begin(), more.end());
    return RunProgram(words);
  }

  const ScratchFolder folder_;
};

TEST_F(RobotStickCheckTest, AStickOfTheHostHasNoBaseAndNoImagesForTheRobot) {
  ASSERT_EQ(RunProgram({"stick", "host", "-o", folder_.File("stick")}).status, 0);
  const ProgramResult result = Check();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, HasSubstr("has no base image"));
  EXPECT_THAT(result.out, HasSubstr("POWERMON.BIN is not for the robot's processor"));
  EXPECT_THAT(result.out, HasSubstr("keep an ERS-210 from booting"));
}

TEST_F(RobotStickCheckTest, AWholeStickHasNoErrors) {
  MakeBase();
  folder_.Write("stick/OPEN-R/SYSTEM/CONF/WLANCONF.TXT", "WEPKEY=abcde\n");
  const ProgramResult result = Check();
  EXPECT_EQ(result.status, 0) << result.out;
  EXPECT_THAT(result.out, HasSubstr("base image: WLAN"));
  EXPECT_THAT(result.out, HasSubstr("nothing is known that keeps an ERS-210 from booting"));
}

TEST_F(RobotStickCheckTest, SizesAreToldOfTheStickAndOfTheImagesOfObjects) {
  MakeBase();
  folder_.Write("stick/OPEN-R/MW/OBJS/MOVER.BIN", std::string(3000, '\0'));
  folder_.Write("stick/OPEN-R/MW/OBJS/UNUSED.BIN", std::string(9000, '\0'));
  // Two designs name the same image, and an image is not there.
  folder_.Write("stick/OPEN-R/MW/CONF/OBJECT.CFG",
                "[ERS-210]\n/MS/OPEN-R/MW/OBJS/POWERMON.BIN\n/MS/OPEN-R/MW/OBJS/MOVER.BIN\n"
                "[ERS-7]\n/MS/OPEN-R/MW/OBJS/MOVER.BIN\n/MS/OPEN-R/MW/OBJS/LOST.BIN\n");
  const uint64_t image_bytes = RobotImage().size() + 3000;
  EXPECT_THAT(Check().out, HasSubstr(" KB, of which 2 images of objects have 4 KB; base image"));
  const auto json = nlohmann::json::parse(Check({"--json"}).out);
  EXPECT_EQ(json["images"], 2);
  EXPECT_EQ(json["image_bytes"], image_bytes);
  EXPECT_GT(json["bytes"], image_bytes + 9000);
}

TEST_F(RobotStickCheckTest, EachMissingPartOfTheBaseIsNamed) {
  MakeBase();
  std::filesystem::remove(folder_.File("stick/OPEN-R/BOOTPARA"));
  std::filesystem::remove(folder_.File("stick/OPEN-R/SYSTEM/OBJS/VRCOMM.BIN"));
  const ProgramResult result = Check();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, HasSubstr("BOOTPARA: is missing"));
  EXPECT_THAT(result.out, HasSubstr("lacks VRCOMM.BIN"));
}

// field-notes.md 5: the wrong DESIGN.CFG ends the boot.
TEST_F(RobotStickCheckTest, DesignCfgMustNameTheRobot) {
  MakeBase();
  EXPECT_THAT(Check({"--robot", "ers7"}).out, HasSubstr("DESIGN.CFG: does not name ERS-7"));
  EXPECT_THAT(Check().out, Not(HasSubstr("DESIGN.CFG")));
}

TEST_F(RobotStickCheckTest, NamesThatAreTooLongAndMissingImagesAreErrorsAsEver) {
  MakeBase();
  folder_.Write("stick/OPEN-R/MW/CONF/OBJECT.CFG",
                "/MS/OPEN-R/MW/OBJS/POWERMON.BIN\n/MS/OPEN-R/MW/OBJS/NAVIGATOR.BIN\n");
  folder_.Write("stick/OPEN-R/MW/OBJS/NAVIGATOR.BIN", RobotImage());
  EXPECT_THAT(Check().out, HasSubstr("'NAVIGATOR.BIN' is not an 8.3 name"));
}

TEST_F(RobotStickCheckTest, WithANetworkButWithoutSettingsItSaysWhatHolds) {
  MakeBase();
  EXPECT_THAT(Check().out, HasSubstr("the robot takes WLANDFLT.TXT"));
}

// field-notes.md 5.6
TEST_F(RobotStickCheckTest, TheBaseWithAConsoleIsNotedBecauseItSeemsDead) {
  MakeBase();
  EXPECT_THAT(Check().out, Not(HasSubstr("the robot may seem dead")));
  for (const char* name : {"ANTTCPIO", "HOOK", "HOOKACT"})
    folder_.Write(std::string("stick/OPEN-R/SYSTEM/OBJS/") + name + ".BIN", "");
  const ProgramResult result = Check();
  EXPECT_EQ(result.status, 0) << result.out;
  EXPECT_THAT(result.out, HasSubstr("base image: WCONSOLE"));
  EXPECT_THAT(result.out, HasSubstr("the robot may seem dead until somebody connects to its port "
                                    "59000"));
}

// field-notes.md 5.8
TEST_F(RobotStickCheckTest, AnImageThatIsNotCompressedIsNoted) {
  MakeBase();
  constexpr char kNote[] = "POWERMON.BIN is not compressed; all images of the SDK's samples are";
  const ProgramResult result = Check();
  EXPECT_EQ(result.status, 0) << result.out;
  EXPECT_THAT(result.out, HasSubstr(kNote));
  PackImage("wb6");
  const ProgramResult compressed = Check();
  EXPECT_EQ(compressed.status, 0) << compressed.out;
  EXPECT_THAT(compressed.out, Not(HasSubstr(kNote)));
}

// field-notes.md 5.8: gzip -6 is known to be good, and the flags that the loader could not read are
// not known.
TEST_F(RobotStickCheckTest, AnImageOfAnotherGzipFlagThanThatOfTheSamplesIsNoted) {
  MakeBase();
  PackImage("wb9");
  const ProgramResult best = Check();
  EXPECT_EQ(best.status, 0) << best.out;
  EXPECT_THAT(best.out, HasSubstr("note: /MS/OPEN-R/MW/OBJS/POWERMON.BIN is compressed as by gzip "
                                  "-9; a robot could not read images of some flags"));
  PackImage("wb1");
  EXPECT_THAT(Check().out, HasSubstr("is compressed as by gzip -1"));
  PackImage("wb6");
  EXPECT_THAT(Check().out, Not(HasSubstr("is compressed as by gzip")));
}

// field-notes.md 5.9
TEST_F(RobotStickCheckTest, AStickThatNobodyCanChangeOverTheNetworkIsNoted) {
  constexpr char kNote[] = "names neither TINYFTPD.BIN nor RCSERVER.BIN";
  MakeBase();
  const ProgramResult result = Check();
  EXPECT_EQ(result.status, 0) << result.out;
  EXPECT_THAT(result.out, HasSubstr(kNote));
  for (const char* name : {"TINYFTPD.BIN", "TinyFTPD.bin", "RCSERVER.BIN"}) {
    folder_.Write(
        "stick/OPEN-R/MW/CONF/OBJECT.CFG",
        std::string("/MS/OPEN-R/MW/OBJS/POWERMON.BIN\n/MS/OPEN-R/MW/OBJS/") + name + "\n");
    EXPECT_THAT(Check().out, Not(HasSubstr(kNote))) << name;
  }
}

TEST_F(RobotStickCheckTest, AStickWithoutANetworkNeedsNoUploads) {
  MakeBase(false);
  EXPECT_THAT(Check().out, Not(HasSubstr("names neither TINYFTPD.BIN")));
}

// field-notes.md 5.10
TEST_F(RobotStickCheckTest, WriteProtectedConfigurationFilesAreNoted) {
  namespace fs = std::filesystem;
  MakeBase();
  EXPECT_THAT(Check().out, Not(HasSubstr("write-protected")));
  for (const char* name : {"CONNECT.CFG", "OBJECT.CFG"})
    fs::permissions(folder_.File(std::string("stick/OPEN-R/MW/CONF/") + name),
                    fs::perms::owner_read | fs::perms::group_read);
  const ProgramResult result = Check();
  EXPECT_EQ(result.status, 0) << result.out;
  EXPECT_THAT(result.out, HasSubstr("MW/CONF: note: has write-protected files: CONNECT.CFG, "
                                    "OBJECT.CFG; nobody can replace them over the network"));
  EXPECT_THAT(result.out, Not(HasSubstr("SYSTEM/CONF: note: has write-protected")));
}

// field-notes.md 5.7
TEST_F(RobotStickCheckTest, SettingsThatAnOldBaseImageDoesNotKnowAreNoted) {
  constexpr char kNote[] = "which needs a base image of the SDK 1.1.4 or later";
  MakeBase();
  const auto check = [&](const std::string& settings) {
    folder_.Write("stick/OPEN-R/SYSTEM/CONF/WLANCONF.TXT", settings);
    return Check().out;
  };
  EXPECT_THAT(check("USE_DHCP=1\n"), HasSubstr(std::string("has USE_DHCP=1, ") + kNote));
  EXPECT_THAT(check("WEPKEY=0x0123456789\n"),
              HasSubstr("has a WEPKEY in hexadecimal digits, which"));
  EXPECT_THAT(check("USE_DHCP=0\nWEPKEY=abcde\n"), Not(HasSubstr(kNote)));
}

// field-notes.md 5.3
TEST_F(RobotStickCheckTest, AnErs7m2CallsItselfErs7) {
  MakeBase();
  const auto check = [&](const std::string& section) {
    folder_.Write("stick/OPEN-R/MW/CONF/OBJECT.CFG",
                  section + "\n/MS/OPEN-R/MW/OBJS/POWERMON.BIN\n");
    return Check().out;
  };
  EXPECT_THAT(check("[ERS-7M2]"),
              HasSubstr("OBJECT.CFG:2: warning: no robot reads the section [ERS-7M2]: an ERS-7M2 "
                        "calls itself ERS-7"));
  EXPECT_THAT(check("[ERS-7]"), Not(HasSubstr("no robot reads")));
  // ERS-7 is a part of this name, and still DESIGN.CFG does not name the robot.
  folder_.Write("stick/OPEN-R/MW/CONF/DESIGN.CFG", "[ERS-7M2]\n0001.0001.*-6\n");
  EXPECT_THAT(Check({"--robot", "ers7"}).out, HasSubstr("DESIGN.CFG: does not name ERS-7"));
  folder_.Write("stick/OPEN-R/MW/CONF/DESIGN.CFG", "[ERS-7M2]\n[ERS-7]\n0001.0001.*-6\n");
  EXPECT_THAT(Check({"--robot", "ers7"}).out, Not(HasSubstr("does not name ERS-7")));
}

TEST_F(RobotStickCheckTest, JsonHasTheRemarksAndTheSizes) {
  MakeBase(false);
  const auto json = nlohmann::json::parse(Check({"--json"}).out);
  EXPECT_EQ(json["base"], "BASIC");
  EXPECT_EQ(json["robot"], "ERS-210");
  EXPECT_EQ(json["errors"], 0);
  EXPECT_GT(json["files"], 15);
}

TEST_F(RobotStickCheckTest, AFolderThatIsNoStickIsRefused) {
  folder_.Write("stick/readme", "");
  const ProgramResult result = Check();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("is no stick"));
  folder_.Write("stick/MS/OPEN-R/MW/CONF/OBJECT.CFG", "");
  EXPECT_THAT(Check().err, HasSubstr("did you mean " + folder_.File("stick/MS") + "?\n"));
}

TEST_F(RobotStickCheckTest, ANewStickHasTheImagesTheBaseAndTheNetwork) {
  MakeBase();
  folder_.Write("hello.bin", RobotImage());
  const ProgramResult made =
      RunProgram({"stick", "new", "-o", folder_.File("new"), folder_.File("hello.bin"), "--base",
                  folder_.File("stick"), "--essid", "kitchen", "--no-wep", "--dhcp"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(folder_.Read("new/OPEN-R/MW/CONF/OBJECT.CFG"),
              HasSubstr("/MS/OPEN-R/MW/OBJS/POWERMON.BIN\n/MS/OPEN-R/MW/OBJS/HELLO.BIN\n"));
  EXPECT_THAT(folder_.Read("new/OPEN-R/SYSTEM/CONF/WLANCONF.TXT"), HasSubstr("ESSID=kitchen\r\n"));
  EXPECT_EQ(RunProgram({"stick", "check", folder_.File("new")}).status, 0);
}

TEST_F(RobotStickCheckTest, NothingIsLeftOfANewStickThatFails) {
  const ProgramResult made =
      RunProgram({"stick", "new", "-o", folder_.File("new"), folder_.File("averylongname.bin")});
  EXPECT_EQ(made.status, 1);
  EXPECT_FALSE(std::filesystem::exists(folder_.File("new")));
}

TEST_F(RobotStickCheckTest, ABaseWithoutABaseImageIsRefusedWithWhatOneHas) {
  folder_.Write("hello.bin", RobotImage());
  folder_.Write("other/OPEN-R/MW/CONF/OBJECT.CFG", "");
  const ProgramResult made = RunProgram({"stick", "new", "-o", folder_.File("new"), "--base",
                                         folder_.File("other"), folder_.File("hello.bin")});
  EXPECT_EQ(made.status, 1);
  EXPECT_THAT(made.err, HasSubstr("other: it has no base image; a base image has "
                                  "OPEN-R/APERIOS.GZ, OPEN-R/APERINIT.GZ, "));
  EXPECT_FALSE(std::filesystem::exists(folder_.File("new")));
}

TEST_F(RobotStickCheckTest, ANewStickWithoutImagesIsNoted) {
  MakeBase();
  const ProgramResult made =
      RunProgram({"stick", "new", "-o", folder_.File("new"), "--base", folder_.File("stick")});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.err, HasSubstr("note: no IMAGE is named, so the stick has no object of yours"));
}

TEST_F(RobotStickCheckTest, TheKeyOfSonysFileIsNotedWhenNoFlagSpeaksOfWep) {
  constexpr char kNote[] = "note: WEP is on with the key of Sony's file, AIBO2; --wep-key gives";
  folder_.Write("hello.bin", RobotImage());
  const ProgramResult made = RunProgram(
      {"stick", "new", "-o", folder_.File("new"), folder_.File("hello.bin"), "--essid", "kitchen"});
  EXPECT_EQ(made.status, 0);
  EXPECT_THAT(made.err, HasSubstr(kNote));
  const std::vector<std::string> wlan = {"stick", "wlan", "--essid", "kitchen"};
  EXPECT_THAT(RunProgram(wlan).err, HasSubstr(kNote));
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"--no-wep"}, {"--wep-key", "abcde"}}) {
    std::vector<std::string> words = wlan;
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(RunProgram(words).err, "") << more[0];
  }
}

TEST_F(RobotStickCheckTest, SettingsOfTheNetworkGoWhereTheRobotReadsThem) {
  MakeBase();
  const ProgramResult wrote = RunProgram(
      {"stick", "wlan", folder_.File("stick"), "--essid", "kitchen", "--ip", "10.1.1.5"});
  EXPECT_EQ(wrote.status, 0) << wrote.err;
  EXPECT_THAT(wrote.err, HasSubstr("IP_GATEWAY 10.0.1.1 is not in the robot's network"));
  EXPECT_THAT(folder_.Read("stick/OPEN-R/SYSTEM/CONF/WLANCONF.TXT"), HasSubstr("ESSID=kitchen"));
}

TEST_F(RobotStickCheckTest, AKeyThatTheRobotDoesNotTakeIsAWrongCommandLine) {
  const ProgramResult refused = RunProgram({"stick", "wlan", "--wep-key", "sixsix"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("5 or 13 characters"));
}

TEST_F(RobotStickCheckTest, AnswersComeFromAPipeAsWell) {
  MakeBase();
  const auto answered = [&](const std::string& answers) {
    return RunProcess({OPENR_PROGRAM, "stick", "wlan", folder_.File("stick")},
                      {.captures_error = true, .captures_out = true, .input = answers});
  };
  EXPECT_EQ(answered("rex\nkitchen\n0\n1\n1\n").status, 0);
  EXPECT_THAT(folder_.Read("stick/OPEN-R/SYSTEM/CONF/WLANCONF.TXT"), HasSubstr("HOSTNAME=rex"));
  const ProcessResult ended = answered("max\n");
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.output, HasSubstr("nothing was written"));
  EXPECT_THAT(folder_.Read("stick/OPEN-R/SYSTEM/CONF/WLANCONF.TXT"), HasSubstr("HOSTNAME=rex"));
}

}  // namespace
}  // namespace openr_host
