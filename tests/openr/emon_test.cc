#include <gmock/gmock.h>

#include "openr/emon/emon_log.h"
#include "openr/emon/emon_text.h"
#include "openr/emon/robot_code.h"
#include "runtime/base/read_file.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

// The parts of a record in the order of field-notes.md 4.5.  Lines and names are those of records
// that users have published.
constexpr char kLog[] =
    "mCOOP exception\n"
    "[exception info]\n"
    " time stamp: 0x000000004daf5139\n"
    " status:$12: 0x0000ff13, cause:$13: 0x00000010\n"
    " badvaddr: $8: 0x00a01003, epc:$14: 0x00b00450\n"
    "[object info]\n"
    " context: 0x80410000, state: 0x00000001\n"
    " last context: 0x00000000,last thread: 0x00000000\n"
    "[register dump]\n"
    " zero:r0: 0x00000000, at:r1: 0x00000001\n"
    " t9:r25: 0x00000019, gp:r28: 0x00b18000\n"
    " ra:r31: 0x00b00480\n"
    "exception code 4: Address error on load\n"
    "[fp registers]\n"
    " f0: 00000000 3ff00000 00000000 40000000\n"
    "[object list]\n"
    " Name Context Thread OID MetaSpace\n"
    " robo-2.b 0x80400000 0x80400100 0x80000050 mCOOP\n"
    " dancer 0x80410000 0x80410100 0x80000051 mCOOP\n"
    "[stack info]\n"
    " area: 0x00c00000 - 0x00c02000, sp: 0x00c00ff0\n"
    "[stack dump]\n"
    "00c00ff0: 11111111 22222222 33333333 44444444  1234 deadbeef 99\n"
    "*\n"
    "00c01010: 55555555 66666666  UUUUffff\n";

TEST(EmonLogTest, PartsAreFoundByTheirNames) {
  const std::optional<EmonLog> log = ParseEmonLog(kLog);
  ASSERT_TRUE(log);
  EXPECT_EQ(log->code, 4u);
  EXPECT_EQ(log->cause, 0x10u);
  EXPECT_EQ(log->bad_address, 0xa01003u);
  EXPECT_EQ(log->epc, 0xb00450u);
  EXPECT_EQ(log->registers[1], 1u);
  EXPECT_EQ(log->registers[25], 0x19u);
  EXPECT_EQ(log->registers[kRobotGp], 0xb18000u);
  EXPECT_EQ(log->registers[kRobotRa], 0xb00480u);
  EXPECT_EQ(log->registers[kRobotSp], 0xc00ff0u);
  EXPECT_FALSE(log->registers[4]);
  ASSERT_EQ(log->objects.size(), 2u);
  EXPECT_EQ(log->objects[0].name, "robo-2.b");
  ASSERT_NE(log->CrashedObject(), nullptr);
  EXPECT_EQ(log->CrashedObject()->name, "dancer");
  EXPECT_EQ(log->CrashedObject()->oid, 0x80000051u);
  EXPECT_EQ(log->CrashedObject()->meta_space, "mCOOP");
}

TEST(EmonLogTest, AStarRepeatsTheLineBefore) {
  const std::optional<EmonLog> log = ParseEmonLog(kLog);
  ASSERT_TRUE(log);
  EXPECT_EQ(log->stack.size(), 10u);
  EXPECT_EQ(log->stack.at(0xc01000), 0x11111111u);
  EXPECT_EQ(log->stack.at(0xc0100c), 0x44444444u);
  EXPECT_EQ(log->stack.at(0xc01014), 0x66666666u);
}

TEST(EmonLogTest, ADamagedAddressDoesNotFillTheMemory) {
  const auto log = ParseEmonLog("epc: 400000\n00000000: 11111111\n*\nfffffff0: 22222222\n");
  ASSERT_TRUE(log);
  EXPECT_EQ(log->stack.size(), size_t{1} << 18);
}

TEST(EmonLogTest, TheCodeMayComeFromTheCause) {
  const auto log = ParseEmonLog("CAUSE=0x0000003c EPC=0x00400010\r\n");
  ASSERT_TRUE(log);
  EXPECT_EQ(log->code, 15u);
}

TEST(EmonLogTest, OtherFormsOfRegistersAreRead) {
  const auto log =
      ParseEmonLog("EPC = 400010\nr0(zero): 00000000 00000001 00000002\nr28(gp) 418000\n");
  ASSERT_TRUE(log);
  EXPECT_EQ(log->epc, 0x400010u);
  EXPECT_EQ(log->registers[2], 2u);
  EXPECT_EQ(log->registers[kRobotGp], 0x418000u);
}

TEST(EmonLogTest, InADelaySlotTheNextInstructionFailed) {
  EXPECT_EQ(ParseEmonLog("cause: 0x80000008 epc: 0x00400010")->FailedAddress(), 0x400014u);
  EXPECT_EQ(ParseEmonLog("cause: 0x00000008 epc: 0x00400010")->FailedAddress(), 0x400010u);
}

TEST(EmonLogTest, OtherTextIsNoLog) {
  EXPECT_FALSE(ParseEmonLog(""));
  EXPECT_FALSE(ParseEmonLog("hello\n12345678 12345678\n"));
}

// An image with four instructions, a call (jalr) the first of them.  It was linked at 0x400000.
class CrashExplanationTest : public testing::Test {
 protected:
  static constexpr uint32_t kCall = 0x400054;  // address of the call in the file
  static constexpr uint32_t kMoved = 0x22200000;

  CrashExplanationTest() : code_("X.BIN", Bytes()) {
    log_.epc = kMoved + kCall + 8;
    log_.registers[kRobotGp] = kMoved + 0x408000;
  }

  static std::string Bytes() {
    return ReadFileOrThrow(std::string(OPENR_TEST_DATA) + "/../../fuzz/corpus/robot_code/linked");
  }
  CrashExplanation Tell() { return ExplainCrash(log_, &code_); }

  RobotCode code_;
  EmonLog log_;
};

TEST_F(CrashExplanationTest, TheRegisterGpSaysWhereTheImageWas) {
  const CrashExplanation explanation = Tell();
  ASSERT_TRUE(explanation.place);
  EXPECT_EQ(explanation.place->in_file, kCall + 8);
  EXPECT_THAT(explanation.problem, HasSubstr("has no names of functions"));
  log_.registers[kRobotGp].reset();
  EXPECT_THAT(Tell().problem, HasSubstr("no register gp"));
}

TEST_F(CrashExplanationTest, OnlyAddressesAfterACallAreCalls) {
  log_.registers[kRobotSp] = 0x1000;
  log_.registers[kRobotRa] = kMoved + kCall + 12;  // after no call
  log_.stack[0xffc] = kMoved + kCall + 8;          // below the stack pointer
  log_.stack[0x1000] = kMoved + kCall;
  log_.stack[0x1004] = kMoved + kCall + 8;
  log_.stack[0x1008] = 0xffffffff;
  const CrashExplanation explanation = Tell();
  ASSERT_EQ(explanation.calls.size(), 1u);
  EXPECT_EQ(explanation.calls[0].in_file, kCall);
  EXPECT_FALSE(explanation.has_more_calls);
}

TEST_F(CrashExplanationTest, ManyCallsAreCutAndTheTextSaysSo) {
  for (uint32_t at = 0; at < 31; ++at) log_.stack[4 * at] = kMoved + kCall + 8;
  const CrashExplanation explanation = Tell();
  EXPECT_EQ(explanation.calls.size(), 30u);
  EXPECT_THAT(ExplanationText(explanation), HasSubstr("\n  and more\n"));
}

TEST_F(CrashExplanationTest, ACrashElsewhereHasNoCalls) {
  log_.stack[0] = kMoved + kCall + 8;
  log_.epc = 0x10;
  EXPECT_THAT(Tell().problem, HasSubstr("is not in this image"));
  EXPECT_TRUE(Tell().calls.empty());
  log_.bad_address = 0x10;
  EXPECT_THAT(Tell().problem, HasSubstr("jumped to an address that is no code"));
  log_.epc.reset();
  EXPECT_THAT(Tell().problem, HasSubstr("has no epc"));
}

TEST_F(CrashExplanationTest, AnImageWithoutGpIsRefused) {
  std::string bytes = Bytes();
  const size_t gp = bytes.find(std::string("\x00\x80\x40\x00", 4));
  ASSERT_NE(gp, std::string::npos);
  bytes.replace(gp, 4, 4, '\0');
  EXPECT_THROW(RobotCode("X.BIN", bytes), std::runtime_error);
}

TEST(EmonCommandTest, SaysCauseAndObjectWithoutAnImage) {
  const ScratchFolder folder;
  folder.Write("EMON.LOG", kLog);
  const ProgramResult result = RunProgram({"emon", folder.File("EMON.LOG")});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out,
            "EXCEPTION 4: a load from an address that is not a multiple of its size, or beyond the "
            "program's addresses, or a jump there\n"
            "ADDRESS 0x00a01003\n"
            "OBJECT dancer (OID 0x80000051, mCOOP)\n"
            "AT 0x00b00450\n"
            "note: give --image to get the function and the line\n");
}

TEST(EmonCommandTest, PrintsNoControlBytesOfNames) {
  const ScratchFolder folder;
  std::string log = kLog;
  const size_t name = log.find(" dancer ");
  log.replace(name, std::string(" dancer ").size(), " d\x1b[5mr ");
  folder.Write("EMON.LOG", log);
  EXPECT_THAT(RunProgram({"emon", folder.File("EMON.LOG")}).out, HasSubstr("OBJECT d?[5mr (OID"));
}

TEST(EmonCommandTest, HelpNamesTheFilesBesideAnImage) {
  EXPECT_THAT(RunProgram({"emon", "--help"}).out,
              HasSubstr("NAME.nosnap.elf, NAME.elf or NAME.DBG has the names"));
}

TEST(EmonCommandTest, RefusesWhatItCannotRead) {
  const ScratchFolder folder;
  folder.Write("text.log", "hello\n");
  folder.Write("EMON.LOG", kLog);
  folder.Write("X.BIN", "hello\n");
  EXPECT_THAT(RunProgram({"emon", folder.File("text.log")}).err,
              HasSubstr("is no EMON.LOG of a robot"));
  const ProgramResult image =
      RunProgram({"emon", folder.File("EMON.LOG"), "--image", folder.File("X.BIN")});
  EXPECT_EQ(image.status, 1);
  EXPECT_THAT(image.err, HasSubstr("X.BIN: is no image for the robot"));
  EXPECT_THAT(RunProgram({"emon", folder.File("EMON.LOG"), "--image", folder.File("no.BIN")}).err,
              HasSubstr("no.BIN: No such file or directory"));
}

}  // namespace
}  // namespace openr_host
