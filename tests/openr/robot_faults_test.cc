// Faults that stop the robot's processor, as docs/limits.md lists them: what a run does by default
// and with --strict.  tests/images/Trouble makes them.
#include <gmock/gmock.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

using nlohmann::json;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

#if !defined(__SANITIZE_ADDRESS__)  // AddressSanitizer reports such faults itself

struct FaultRun {
  ProgramResult result;
  json report;
  std::string record;  // EMON.LOG; "" if there is none

  // The texts of the findings, one a line.
  std::string Findings() const {
    std::string texts;
    for (const json& finding : report["findings"]) {
      texts += finding["severity"].get<std::string>() + ": " + finding["text"].get<std::string>();
      texts += "\n";
    }
    return texts;
  }
  int StackOfTrouble() const {
    for (const json& object : report["objects"]) {
      if (object["name"] == "Trouble") return object["stack_bytes_max"].get<int>();
    }
    return -1;
  }
};

FaultRun RunFault(const std::string& word, bool is_strict = false) {
  const ScratchFolder stick;
  stick.MakeTrouble(word);
  std::vector<std::string> arguments{"run",       "--for", "100ms",   "--rate",     "max",
                                     "--rc-port", "0",     "--stick", stick.path(), "--json"};
  if (is_strict) arguments.push_back("--strict");
  FaultRun run;
  run.result = RunProgram(arguments);
  run.report = json::parse(run.result.out, nullptr, false);
  run.record = stick.Read("OPEN-R/EMON.LOG");
  return run;
}

// Both ways of running it stop there; the record and the finding name the line.
void ExpectStop(const FaultRun& run, const std::string& name) {
  EXPECT_EQ(run.result.status, 1) << run.result.err;
  EXPECT_THAT(run.record, HasSubstr("EXCEPTION " + name));
  EXPECT_THAT(run.record,
              ContainsRegex("TROUBLE.BIN\\+0x[0-9a-f]+ .*\\((Faults|Trouble).cc:[0-9]+\\)"));
  EXPECT_THAT(run.Findings(), HasSubstr("error: crash: " + name));
}

// Expects that the run has gone on and has one warning, which matches `pattern`.
void ExpectWarning(const FaultRun& run, const std::string& pattern) {
  EXPECT_EQ(run.result.status, 0) << run.result.err;
  EXPECT_THAT(run.Findings(), ContainsRegex("^warning: " + pattern));
  EXPECT_EQ(run.report["findings"].size(), 1u) << run.Findings();
  EXPECT_EQ(run.record, "");
}

TEST(RobotFaultsTest, ANaNIsAWarningWithItsLineAndStrictlyTheEnd) {
  ExpectWarning(RunFault("nan"),
                "DoStart, at Faults.cc:[0-9]+: a floating-point operation made NaN");
  ExpectStop(RunFault("nan", true), "SIGFPE (a NaN was made");
}

TEST(RobotFaultsTest, SoIsOneThatTheLibraryMadeAtTheLineOfItsCaller) {
  ExpectWarning(RunFault("nanlib"),
                "DoStart, at Faults.cc:[0-9]+: a floating-point operation made NaN");
  ExpectStop(RunFault("nanlib", true), "SIGFPE (a NaN was made");
}

TEST(RobotFaultsTest, ANaNThatIsPrintedIsAWarningWithItsLineAndStrictlyTheEnd) {
  ExpectWarning(RunFault("nanprint"), "DoStart: a NaN was printed, at Faults.cc:[0-9]+: the robot");
  ExpectStop(RunFault("nanprint", true), "a NaN was printed");
}

// A small result of the object's own before it does not hide the denormal number.
TEST(RobotFaultsTest, ADenormalFromElsewhereIsAWarningWithItsLineAndStrictlyTheEnd) {
  for (const char* const word : {"denormal", "smallfirst"}) {
    ExpectWarning(RunFault(word), "DoStart, at Faults.cc:[0-9]+: a denormal number was used");
    ExpectStop(RunFault(word, true), "SIGFPE (a denormal number was used)");
  }
}

// Results that would be denormal are 0 on the robot, so a program that makes them works.
TEST(RobotFaultsTest, ADenormalOfItsOwnMakingIs0AndNoFinding) {
  for (const bool is_strict : {false, true})
    EXPECT_THAT(RunFault("small", is_strict).Findings(), IsEmpty());
}

// Whether the robot stops when it is used is not proven.
TEST(RobotFaultsTest, AnInfinityIsAWarningStrictlyToo) {
  for (const bool is_strict : {false, true}) {
    ExpectWarning(RunFault("infinity", is_strict),
                  "DoStart, at Faults.cc:[0-9]+: .* made an infinity");
  }
}

TEST(RobotFaultsTest, AConversionThatDoesNotFitIsAWarningOnceAndStrictlyTheEnd) {
  for (const char* const word : {"convert", "constant"}) {
    ExpectWarning(RunFault(word),
                  "conversion of 10000000000 to 'int'.* at Faults.cc:[0-9]+: exception");
    ExpectStop(RunFault(word, true), "conversion of 10000000000 to 'int'");
  }
}

// The robot converts to 32 bits first.
TEST(RobotFaultsTest, AConversionThatTheRobotDoesWithoutAFaultIsNone) {
  for (const bool is_strict : {false, true})
    EXPECT_THAT(RunFault("unsigned", is_strict).Findings(), IsEmpty());
}

TEST(RobotFaultsTest, AnUnalignedAccessIsAWarningForEachLineAndStrictlyTheEnd) {
  const FaultRun run = RunFault("unaligned");
  EXPECT_EQ(run.result.status, 0);
  EXPECT_EQ(run.report["findings"].size(), 2u) << run.Findings();
  EXPECT_THAT(run.Findings(), ContainsRegex("warning: unaligned access to 'int', whose address has "
                                            "to be a multiple of 4, at Faults.cc:[0-9]+"));
  ExpectStop(RunFault("unaligned", true), "unaligned access to 'int'");
}

TEST(RobotFaultsTest, AMultipleOfFourIsEnoughForWhatHasPointersOfFourBytesThere) {
  for (const bool is_strict : {false, true})
    EXPECT_THAT(RunFault("four", is_strict).Findings(), IsEmpty());
}

TEST(RobotFaultsTest, ADivisionByAConstantZeroStopsThoughNobodyUsesTheResult) {
  for (const bool is_strict : {false, true})
    ExpectStop(RunFault("zero", is_strict), "a division by zero at Faults.cc:");
}

// The robot's division instruction never stops, and its compiler checks only for 0.
TEST(RobotFaultsTest, TheSmallestIntegerByMinusOneIsAWarningStrictlyToo) {
  for (const bool is_strict : {false, true}) {
    const FaultRun run = RunFault("smallest", is_strict);
    ExpectWarning(run,
                  "DoStart, at Faults.cc:[0-9]+: the smallest integer was divided by -1, .* the "
                  "robot does not stop");
    EXPECT_THAT(run.result.err,
                HasSubstr("quotients -2147483648 -9223372036854775808, remainders 0 0\n"));
  }
}

TEST(RobotFaultsTest, ABreakpointStops) {
  ExpectStop(RunFault("breakpoint"), "SIGTRAP (a breakpoint in the code)");
}

TEST(RobotFaultsTest, ExecutedDataAreCalledThat) {
  for (const bool is_strict : {false, true})
    ExpectStop(RunFault("execute", is_strict), "SIGSEGV (data were executed)");
}

TEST(RobotFaultsTest, AMethodThatWritesToANullObjectStops) {
  for (const bool is_strict : {false, true})
    ExpectStop(RunFault("nullmethod", is_strict), "SIGSEGV (an address that is not the object's)");
}

TEST(RobotFaultsTest, AWildPointerStops) {
  for (const bool is_strict : {false, true}) {
    const FaultRun run = RunFault("wild", is_strict);
    ExpectStop(run, "SIGSEGV (an address that is not the object's)");
    EXPECT_THAT(run.record, HasSubstr("at address 0x12345678\n"));
  }
}

#if defined(__x86_64__)  // other processors tell such an address
TEST(RobotFaultsTest, AWildPointerThatIsNoAddressOfTheProcessorIsNotCalledNull) {
  for (const bool is_strict : {false, true}) {
    const FaultRun run = RunFault("wildfar", is_strict);
    ExpectStop(run, "SIGSEGV (an address that is not the object's)");
    EXPECT_THAT(run.record, HasSubstr(" at an address that this processor cannot use\n"));
    EXPECT_THAT(run.record, HasSubstr("0xffffffff, epc:"));
  }
}
#endif

TEST(RobotFaultsTest, RegionsThatAreNeverGivenUpAreNamedWithTheLineThatMakesThem) {
  EXPECT_THAT(RunFault("regions").Findings(),
              ContainsRegex("65535 regions are alive, 65535 of them made at Faults.cc:[0-9]+"));
}

TEST(RobotFaultsTest, ARegionOfMoreThanTheRobotsMemoryIsAnErrorStrictlyToo) {
  for (const bool is_strict : {false, true}) {
    const FaultRun run = RunFault("hugeregion", is_strict);
    EXPECT_EQ(run.result.status, 1) << run.result.err;
    EXPECT_THAT(run.Findings(),
                ContainsRegex("^error: DoStart: no shared memory for 33554433 bytes, at "
                              "Faults.cc:[0-9]+: a region has at most 32 MiB"));
  }
}

TEST(RobotFaultsTest, APrivateRegionDeletedTwiceIsAWarning) {
  ExpectWarning(RunFault("deletetwice"),
                "DoStart: a region of NewRegion\\(\\) is deleted that was deleted before, at "
                "Faults.cc:[0-9]+");
}

TEST(RobotFaultsTest, MemoryThatIsUsedUpIsNamedWithTheLineThatAsked) {
  EXPECT_THAT(RunFault("memory", true).Findings(),
              ContainsRegex("error: no memory for 1048576 bytes, at Faults.cc:[0-9]+: this object "
                            "holds [0-9]+, all objects [0-9]+ of the 33554432 the robot has"));
}

// ---- The stack

TEST(RobotFaultsTest, FramesOfTheSdkAndOfTheCLibraryAreNoStackOfTheHandler) {
  const FaultRun run = RunFault("libraries");
  EXPECT_THAT(run.Findings(), IsEmpty());
  EXPECT_GT(run.StackOfTrouble(), 50);
  EXPECT_LT(run.StackOfTrouble(), 800);
}

TEST(RobotFaultsTest, MoreStackThanTheOcfFileGivesIsAWarningStrictlyToo) {
  for (const bool is_strict : {false, true}) {
    const FaultRun run = RunFault("some", is_strict);
    ExpectWarning(run,
                  "a handler's own functions used 10[0-9]+ bytes of stack, the .ocf file gives "
                  "8192: on the robot an overflow damages other memory");
    EXPECT_GE(run.StackOfTrouble(), 10000);
    EXPECT_LT(run.StackOfTrouble(), 10500);
  }
}

TEST(RobotFaultsTest, StrictlyTwiceAsMuchStopsTheRobot) {
  const FaultRun run = RunFault("deep", true);
  EXPECT_EQ(run.result.status, 1);
  EXPECT_THAT(run.Findings(),
              ContainsRegex("error: a handler's own functions used 40[0-9]+ bytes"));
  EXPECT_THAT(run.Findings(), HasSubstr("(--strict: the robot stops)"));
  EXPECT_LT(run.report["virtual_time_s"].get<double>(), 0.1);
  EXPECT_EQ(run.report["ended_by"], "strict");
  EXPECT_THAT(run.result.err, Not(HasSubstr("does not boot")));
}

// Expects that a run ends while it loads the image, and that the record and the finding say so.
void ExpectEarlyEnd(const std::string& word, const std::string& exception) {
  const FaultRun run = RunFault(word);
  EXPECT_EQ(run.result.status, 1) << run.result.err;
  EXPECT_THAT(run.record, HasSubstr("EXCEPTION " + exception));
  EXPECT_THAT(run.record, HasSubstr("OBJECT Trouble, constructors of its globals"));
  EXPECT_THAT(run.record, HasSubstr("Early.cc"));
  EXPECT_THAT(run.result.err, HasSubstr("ended by crash: Trouble: crash: " + exception));
  EXPECT_THAT(run.Findings(), HasSubstr("error: crash: " + exception));
}

TEST(RobotFaultsTest, AConstructorUsesFilesAsAHandlerDoes) {
  const ScratchFolder stick;
  stick.MakeTrouble("earlyfiles");
  const ProgramResult run =
      RunProgram({"run", "--stick", stick.path(), "--for", "100ms", "--rate", "max", "--no-panel"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("early files: from a constructor, 4 from, closed 0\n"));
}

TEST(RobotFaultsTest, ACrashOfAConstructorHasARecord) { ExpectEarlyEnd("earlycrash", "SIGSEGV"); }

TEST(RobotFaultsTest, AConstructorThatEndsTheProgramIsRefused) {
  ExpectEarlyEnd("earlyabort", "a constructor of a global object has called abort()");
  ExpectEarlyEnd("earlyassert", "a constructor of a global object has called abort()");
  ExpectEarlyEnd("earlyexit", "a constructor of a global object has called exit()");
}

// A command that only looks at the stick loads its images, too.
TEST(RobotFaultsTest, ACrashOfAConstructorIsNamedByOtherCommands) {
  const ScratchFolder stick;
  stick.MakeTrouble("earlycrash");
  const ProgramResult result = RunProgram({"graph", "--stick", stick.path()});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("OBJECT Trouble, constructors of its globals"));
  EXPECT_THAT(result.err, HasSubstr("ended by crash: Trouble: "));
}

TEST(RobotFaultsTest, AConstructorThatDoesNotReturnIsEnded) {
  const ScratchFolder stick;
  stick.MakeTrouble("earlyhang");
  const ProgramResult result = RunProgram(
      {"run", "--stick", stick.path(), "--rc-port", "0", "--no-panel", "--handler-limit", "200ms"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(
      result.err,
      HasSubstr("the loading or unloading of an image does not end: Trouble, constructors"));
  EXPECT_THAT(result.err, HasSubstr("ended by handler-limit: Trouble: "));
}

// The images of --jobs are loaded once, before the robots have processes of their own.
TEST(RobotFaultsTest, AConstructorEndsRobotsWithProcessesOfTheirOwn) {
  const ScratchFolder stick;
  const auto run = [&stick](const std::string& word) {
    stick.Write("OPEN-R/MW/DATA/P/TROUBLE.TXT", word);
    return RunProgram({"run", "--robots", "2", "--jobs", "2", "--for", "100ms", "--json", "--stick",
                       stick.path(), "--handler-limit", "200ms"});
  };
  stick.MakeTrouble("");
  const ProgramResult hang = run("earlyhang");
  EXPECT_EQ(hang.status, 1) << hang.err;
  EXPECT_EQ(json::parse(hang.out, nullptr, false)["ended_by"], "handler-limit");
  EXPECT_THAT(hang.err, HasSubstr("has used more than 0.2 s of processor time (--handler-limit)"));
  EXPECT_EQ(stick.Read("OPEN-R/EMON.LOG"), "");
  const ProgramResult crash = run("earlycrash");
  EXPECT_EQ(crash.status, 1) << crash.err;
  const json report = json::parse(crash.out, nullptr, false);
  EXPECT_EQ(report["ended_by"], "crash") << crash.out;
  EXPECT_EQ(report["findings"].at(0)["object"], "Trouble");
  EXPECT_THAT(stick.Read("OPEN-R/EMON.LOG"),
              HasSubstr("OBJECT Trouble, constructors of its globals"));
}

// The robot never runs destructors of global objects, nor functions that were given to atexit().
TEST(RobotFaultsTest, NoDestructorOfAGlobalRunsAtTheEnd) {
  for (const char* const word : {"latecrash", "lateexit", "latehang", "lateclose"}) {
    const ScratchFolder stick;
    stick.MakeTrouble(word);
    const ProgramResult result =
        RunProgram({"run", "--for", "100ms", "--rate", "max", "--rc-port", "0", "--stick",
                    stick.path(), "--report", stick.File("report.json")});
    EXPECT_EQ(result.status, 0) << word << ": " << result.err;
    const json report = json::parse(stick.Read("report.json"), nullptr, false);
    ASSERT_TRUE(report.is_object()) << word;
    EXPECT_EQ(report["ended_by"], "time");
    EXPECT_FALSE(report.contains("error"));
    EXPECT_EQ(stick.Read("OPEN-R/EMON.LOG"), "");
  }
}

#if !defined(__SANITIZE_THREAD__)  // ThreadSanitizer has a heap of its own
TEST(RobotFaultsTest, DamageThatTheCLibraryFindsHasARecord) {
  for (const bool is_strict : {false, true}) {
    ExpectStop(RunFault("damage", is_strict),
               "SIGABRT (the C library ended the process: it found the object's heap, a stream or "
               "the stack damaged)");
  }
}
#endif

#endif

}  // namespace
}  // namespace openr_host
