#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "MtnFile.h"
#include "MtnName.h"
#include "mtn_bytes.h"

namespace openr_host {
namespace {

constexpr const char* kTiltInFiles = "PRM:/r1/c1-Joint2:j1";
constexpr const char* kPan = "PRM:/r1/c1/c2-Joint2:j2";

const RobotConstants* Ers210() { return FindRobot("ERS-210"); }

bool Read(MtnFile* file, const std::vector<uint8_t>& bytes) {
  return file->Read(bytes.data(), bytes.size());
}

// The complaint about `bytes`; "" when they are a motion.
std::string ErrorIn(const std::vector<uint8_t>& bytes) {
  MtnFile file;
  if (Read(&file, bytes)) return "";
  EXPECT_EQ(file.NumKeyFrames(), 0) << "half loaded";
  EXPECT_EQ(file.NumJoints(), 0) << "half loaded";
  return file.Error();
}
std::string ErrorIn(const MtnBytes& mtn) { return ErrorIn(mtn.Bytes()); }

std::vector<std::string> WarningsIn(const MtnBytes& mtn) {
  MtnFile file;
  EXPECT_TRUE(Read(&file, mtn.Bytes())) << file.Error();
  return file.Warnings();
}

MtnBytes TwoJoints() {
  MtnBytes mtn;
  mtn.locators = {kTiltInFiles, kPan};
  mtn.key_frames = {
      {0, {100, -200}, 1, 2, 3}, {3, {300, -400}, 4, 5, 6}, {20, {500, 600}, 7, 8, 9}};
  return mtn;
}

TEST(MtnFileTest, ReadsEveryFieldOfAMotion) {
  MtnFile file;
  ASSERT_TRUE(Read(&file, TwoJoints().Bytes())) << file.Error();
  EXPECT_EQ(file.Name(), "a_stand#test");
  EXPECT_EQ(file.Creator(), "openr-host tests");
  EXPECT_EQ(file.DesignLabel(), "DRX-900");
  EXPECT_EQ(file.MajorVersion(), 1);
  EXPECT_EQ(file.MinorVersion(), 2);
  EXPECT_EQ(file.NumKeyFrames(), 3);
  EXPECT_EQ(file.Locator(1), kPan);
  EXPECT_EQ(file.Angle(2, 1), 600);
  EXPECT_EQ(file.Angle(0, 1), -200);
  EXPECT_EQ(file.Attitude(1, 2), 6);
  EXPECT_EQ(file.Interpolation(1), 20);
  EXPECT_TRUE(file.Warnings().empty());
}

TEST(MtnFileTest, DurationIsTheSumOfCountPlusOneTimes16Ms) {
  MtnFile file;
  ASSERT_TRUE(Read(&file, TwoJoints().Bytes()));
  EXPECT_EQ(file.TimeMs(0), 0);
  EXPECT_EQ(file.TimeMs(1), 4 * 16);
  EXPECT_EQ(file.DurationMs(), (4 + 21) * 16);
}

TEST(MtnFileTest, LongestMotionStillHasADuration) {
  MtnBytes mtn = MtnBytes::OneJoint(kTiltInFiles, std::vector<int32_t>(MTN_MAX_KEYFRAMES, 0),
                                    MTN_MAX_INTERPOLATION);
  MtnFile file;
  ASSERT_TRUE(Read(&file, mtn.Bytes())) << file.Error();
  EXPECT_EQ(file.DurationMs(), int64_t{MTN_MAX_KEYFRAMES - 1} * (MTN_MAX_INTERPOLATION + 1) * 16);
}

TEST(MtnFileTest, AcceptsASingleKeyFrame) {
  EXPECT_EQ(ErrorIn(MtnBytes::OneJoint(kTiltInFiles, {5})), "");
}

TEST(MtnFileTest, RefusesAnEmptyFile) {
  EXPECT_EQ(ErrorIn(std::vector<uint8_t>{}), "header, offset 0: the file has only 0 bytes");
}

TEST(MtnFileTest, RefusesBadMagic) {
  MtnBytes mtn = TwoJoints();
  mtn.magic = "OMTM";
  EXPECT_EQ(ErrorIn(mtn), "header, offset 0: a motion file begins with 'OMTN', this one does not");
}

TEST(MtnFileTest, RefusesAFileCutAtAnyByte) {
  const std::vector<uint8_t> whole = TwoJoints().Bytes();
  for (size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(ErrorIn(std::vector<uint8_t>(whole.begin(), whole.begin() + size)), "")
        << size << " bytes";
  }
}

TEST(MtnFileTest, MissingKeyFramesAreNamedWithSectionOffsetAndSizes) {
  MtnBytes mtn = TwoJoints();
  mtn.key_frame_count = 4;
  EXPECT_EQ(ErrorIn(mtn),
            "section 3, offset 144: 4 key frames of 2 joints need 92 bytes, the file has 68 left");
}

TEST(MtnFileTest, ASectionThatEndsInItsHeaderIsNamedWithTheBytesItNeeds) {
  std::vector<uint8_t> bytes = TwoJoints().Bytes();
  bytes.resize(144);
  EXPECT_EQ(ErrorIn(bytes),
            "section 3, offset 144: 3 key frames of 2 joints need 68 bytes, the file has 0 left");
  bytes.resize(143);
  EXPECT_EQ(ErrorIn(bytes), "section 3, offset 132: needs 12 bytes, the file has 11 left");
}

TEST(MtnFileTest, RefusesAbsurdCounts) {
  MtnBytes none = TwoJoints();
  none.key_frame_count = 0;
  EXPECT_EQ(ErrorIn(none), "section 0, offset 20: 0 key frames, must be 1 to 32767");
  MtnBytes many = TwoJoints();
  many.key_frame_count = 65535;
  EXPECT_EQ(ErrorIn(many), "section 0, offset 20: 65535 key frames, must be 1 to 32767");
  MtnBytes joints = TwoJoints();
  joints.joint_count = 1000;
  EXPECT_EQ(ErrorIn(joints), "section 2, offset 84: 1000 joints, must be 1 to 64");
  MtnBytes gap = TwoJoints();
  gap.key_frames[2].interpolation = 0xffffffff;
  EXPECT_EQ(ErrorIn(gap),
            "section 3, offset 188: 4294967295 interpolation frames before key frame 2, at most "
            "3749 make sense");
}

TEST(MtnFileTest, RefusesAnAngleBeyondATurn) {
  MtnBytes mtn = TwoJoints();
  mtn.key_frames[1].angles_urad[0] = 6283187;
  EXPECT_EQ(ErrorIn(mtn),
            "section 3, offset 180: key frame 1: PRM:/r1/c1-Joint2:j1 is 6283187 urad, beyond "
            "+-6283186 no angle "
            "makes sense");
  mtn.key_frames[1].angles_urad[0] = -2147483647 - 1;
  EXPECT_NE(ErrorIn(mtn), "");
  mtn.key_frames[1].angles_urad[0] = -6283186;
  EXPECT_EQ(ErrorIn(mtn), "");
}

// A float not-a-number in place of an angle, 0x7fc00000, is a very large integer.
TEST(MtnFileTest, RefusesTheBitsOfANonFiniteFloat) {
  for (const uint32_t bits : {0x7fc00000u, 0x7f800000u, 0xff800000u}) {
    MtnBytes mtn = TwoJoints();
    mtn.key_frames[0].angles_urad[1] = static_cast<int32_t>(bits);
    EXPECT_NE(ErrorIn(mtn), "") << std::hex << bits;
  }
}

TEST(MtnFileTest, RefusesAnAbsurdAttitude) {
  MtnBytes mtn = TwoJoints();
  mtn.key_frames[0].pitch = 100000000;
  EXPECT_EQ(ErrorIn(mtn),
            "section 3, offset 148: key frame 0: pitch is 100000000 urad, beyond +-62831853 no "
            "angle makes sense");
}

TEST(MtnFileTest, RefusesAnotherFrameRate) {
  MtnBytes mtn = TwoJoints();
  mtn.rate_ms = 8;
  EXPECT_EQ(ErrorIn(mtn), "section 0, offset 22: frame rate is 8 ms, only 16 can be played");
}

TEST(MtnFileTest, RefusesAnotherDataType) {
  MtnBytes mtn = TwoJoints();
  mtn.data_type = 1;
  EXPECT_EQ(ErrorIn(mtn), "section 3, offset 140: data type is 1, only 0 (angles) is known");
}

TEST(MtnFileTest, RefusesSectionsOutOfOrder) {
  MtnBytes mtn = TwoJoints();
  mtn.section_number[2] = 3;
  EXPECT_EQ(ErrorIn(mtn), "section 2, offset 76: section number is 3, expected 2");
}

TEST(MtnFileTest, RefusesAJointListedTwice) {
  MtnBytes mtn = TwoJoints();
  mtn.locators[1] = kTiltInFiles;
  EXPECT_EQ(ErrorIn(mtn), "section 2, offset 128: joint 'PRM:/r1/c1-Joint2:j1' is listed twice");
}

// A length byte too small, as a public but broken file has it: the rest of the name is taken
// for the next strings.
TEST(MtnFileTest, RefusesANameLongerThanItsLengthByte) {
  std::vector<uint8_t> bytes = TwoJoints().Bytes();
  bytes[36] = 4;
  EXPECT_NE(ErrorIn(bytes), "");
}

TEST(MtnFileTest, ASectionSizeTooLargeForItsKeyFramesIsAWarning) {
  MtnBytes mtn = TwoJoints();
  mtn.section_size[3] = 160;
  EXPECT_EQ(WarningsIn(mtn),
            (std::vector<std::string>{
                "section 3: size says 160 bytes, 3 key frames of 2 joints have 80"}));
}

TEST(MtnFileTest, AWrongSizeOfTheJointListIsAWarningWhenTheNextSectionIsFound) {
  MtnBytes mtn = TwoJoints();
  mtn.section_size[2] = 4000000000;
  EXPECT_EQ(
      WarningsIn(mtn),
      (std::vector<std::string>{"section 2: size says 4000000000 bytes, its content has 56"}));
}

TEST(MtnFileTest, BytesAfterTheMotionAreAWarning) {
  std::vector<uint8_t> bytes = TwoJoints().Bytes();
  bytes.resize(bytes.size() + 7);
  MtnFile file;
  ASSERT_TRUE(Read(&file, bytes));
  EXPECT_EQ(file.Warnings(), (std::vector<std::string>{"7 bytes after section 3 are ignored"}));
}

TEST(MtnFileTest, ARefusalLeavesNothingOfTheMotionBefore) {
  MtnFile file;
  ASSERT_TRUE(Read(&file, TwoJoints().Bytes()));
  EXPECT_FALSE(file.Read(nullptr, 0));
  EXPECT_EQ(file.NumKeyFrames(), 0);
  EXPECT_EQ(file.DurationMs(), 0);
}

TEST(MtnFileTest, AnyByteMayBeWrongWithoutACrash) {
  const std::vector<uint8_t> whole = TwoJoints().Bytes();
  for (size_t at = 0; at < whole.size(); ++at) {
    for (const int flip : {0x01, 0x80, 0xff}) {
      std::vector<uint8_t> bytes = whole;
      bytes[at] ^= flip;
      MtnFile file;
      if (Read(&file, bytes)) file.MapTo(Ers210());
    }
  }
}

TEST(MtnFileTest, JointsAreMappedByLocatorNotByPosition) {
  MtnBytes mtn = TwoJoints();
  std::swap(mtn.locators[0], mtn.locators[1]);
  MtnFile file;
  ASSERT_TRUE(Read(&file, mtn.Bytes()));
  ASSERT_TRUE(file.MapTo(Ers210())) << file.Error();
  EXPECT_EQ(file.RobotJoint(0), FindJoint(Ers210(), kPan));
  EXPECT_EQ(file.RobotJoint(1), FindJoint(Ers210(), kTiltInFiles));
}

TEST(MtnFileTest, AnUnknownLocatorIsRefusedWhateverTheDesignLabelSays) {
  MtnFile file;
  ASSERT_TRUE(Read(&file, MtnBytes::OneJoint("PRM:/r1/c1-Joint2:11", {0, 1}).Bytes()));
  EXPECT_FALSE(file.MapTo(Ers210()));
  EXPECT_EQ(file.Error(),
            "section 2, offset 86: joint 0: the ERS-210 has no joint 'PRM:/r1/c1-Joint2:11'");
  EXPECT_TRUE(file.MapTo(FindRobot("ERS-7")));
}

TEST(MtnFileTest, PlungersHaveTwoPositionsAndNoLimits) {
  MtnBytes mtn = TwoJoints();
  mtn.locators[1] = "PRM:/r1/c1/c2/c3/e2-Joint3:j6";
  MtnFile file;
  ASSERT_TRUE(Read(&file, mtn.Bytes()));
  ASSERT_TRUE(file.MapTo(Ers210())) << file.Error();
  EXPECT_EQ(file.RobotJoint(0), FindJoint(Ers210(), kTiltInFiles));
  EXPECT_EQ(file.RobotPlunger(0), -1);
  EXPECT_EQ(file.RobotJoint(1), -1);
  EXPECT_EQ(file.RobotPlunger(1), 1);
  EXPECT_TRUE(file.Warnings().empty());
  EXPECT_FALSE(file.MapTo(FindRobot("ERS-220")));  // the ERS-220 has no ears
  EXPECT_NE(file.Error().find("joint 1: the ERS-220 has no joint 'PRM:/r1/c1/c2/c3/e2-Joint3:j6'"),
            std::string::npos)
      << file.Error();
}

// Names as they are on the robot, of which a motion cannot move a light.
TEST(MtnFileTest, ANameThatIsNoJointIsToldFromOneTheRobotLacks) {
  const std::pair<const char*, const char*> names[] = {
      {"PRM:/r1/c1/c2/c3/l1-LED2:l1", "a light"},
      {"PRM:/r1/c1/c2/c3/p1-Sensor:p1", "a sensor"},
      {"PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1", "the camera"},
  };
  for (const auto& [locator, what] : names) {
    MtnFile file;
    ASSERT_TRUE(Read(&file, MtnBytes::OneJoint(locator, {0, 1}).Bytes()));
    EXPECT_FALSE(file.MapTo(Ers210()));
    EXPECT_EQ(file.Error(), std::string("section 2, offset 86: joint 0: '") + locator +
                                "' of the ERS-210 is " + what + ", no joint");
  }
}

TEST(MtnFileTest, AForeignDesignLabelAloneIsNoReasonToRefuse) {
  MtnBytes mtn = TwoJoints();
  mtn.label = "DRX-1000";
  MtnFile file;
  ASSERT_TRUE(Read(&file, mtn.Bytes()));
  EXPECT_TRUE(file.MapTo(Ers210()));
}

TEST(MtnFileTest, LeavingTheSoftwareLimitsIsAWarning) {
  MtnFile file;
  ASSERT_TRUE(Read(&file, MtnBytes::OneJoint(kTiltInFiles, {0, 785398}).Bytes()));
  ASSERT_TRUE(file.MapTo(Ers210()));
  EXPECT_EQ(file.Warnings(),
            (std::vector<std::string>{"key frame 1: neck_tilt is 785398 urad, outside its software "
                                      "limits -1431170 to 750492"}));
}

TEST(MtnFileTest, LeavingTheSoftwareLimitsIsAWarningFromTheFirstKeyFrameOn) {
  MtnFile file;
  ASSERT_TRUE(Read(&file, MtnBytes::OneJoint(kTiltInFiles, {785398, 0}).Bytes()));
  ASSERT_TRUE(file.MapTo(Ers210()));
  ASSERT_EQ(file.Warnings().size(), 1u);
  EXPECT_EQ(file.Warnings()[0].substr(0, 12), "key frame 0:");
}

TEST(MtnNameTest, IsWrittenInUpperCase) {
  char name[MTN_NAME_SIZE];
  std::string error;
  ASSERT_TRUE(MtnFileName("wwFwd.mtn", name, &error)) << error;
  EXPECT_STREQ(name, "WWFWD.MTN");
  EXPECT_TRUE(MtnFileName("12345678.ABC", name, &error));
}

TEST(MtnNameTest, RefusesWhatIsNoBareNameOfEightPlusThree) {
  char name[MTN_NAME_SIZE];
  for (const char* bad : {"", ".", "A", "A.", ".MTN", "123456789.MTN", "A.MTNX", "A.B.C",
                          "../A.MTN", "A/B.MTN", "/MS/A.MTN", "A B.MTN", "A\\B.MTN", "A*.MTN"}) {
    std::string error;
    EXPECT_FALSE(MtnFileName(bad, name, &error)) << bad;
    EXPECT_NE(error, "") << bad;
    EXPECT_STREQ(name, "") << bad;
  }
}

// The vendor's files stay outside the project; the folder is named by OPENR_MTN_REFERENCE.
TEST(MtnReferenceFilesTest, AllAreReadWithoutAWarning) {
  const char* folder = std::getenv("OPENR_MTN_REFERENCE");
  if (folder == nullptr || !std::filesystem::is_directory(folder))
    GTEST_SKIP() << "OPENR_MTN_REFERENCE names no folder";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().string());
    std::ifstream stream(entry.path(), std::ios::binary);
    const std::vector<uint8_t> bytes{std::istreambuf_iterator<char>(stream), {}};
    MtnFile file;
    ASSERT_TRUE(Read(&file, bytes)) << file.Error();
    const bool is_ers7 = entry.path().filename().string()[0] == '7';
    EXPECT_EQ(file.MapTo(Ers210()), !is_ers7) << file.Error();
    EXPECT_TRUE(file.Warnings().empty()) << file.Warnings()[0];
    // Some leave the software limits of the ERS-7.
    EXPECT_TRUE(file.MapTo(FindRobot(is_ers7 ? "ERS-7" : "ERS-210"))) << file.Error();
  }
}

}  // namespace
}  // namespace openr_host
