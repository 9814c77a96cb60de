// The same input gives the same run, also for programs that send addresses and bytes that they
// never set.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "tests/distribution/sticks.h"

namespace openr_host {
namespace {

// Compares the hashes of runs that are started by another program or in another environment.
class EqualRunsTest : public testing::Test {
 protected:
  void SetUp() override {
    MakeStick(stick_, {"REVEALER.BIN", "MIRROR.BIN"},
              "Revealer.Out.Bytes.S Mirror.In.Bytes.O\n"
              "Mirror.Out.Bytes.S Revealer.Back.Bytes.O\n");
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "addresses are not planned with AddressSanitizer";
#endif
  }

  Words Flags(const Words& more = {}) const { return FlagsOf(stick_.path(), more); }

  static Words FlagsOf(const std::string& stick, const Words& more) {
    return kQuickly + Words{"--stick", stick, "--for", "1s"} + more;
  }

  // Runs the first word as the program, which starts openr.
  static ProgramResult Start(const Words& words) {
    ProgramRun run({words.begin() + 1, words.end()}, words[0]);
    return run.Finish();
  }

  static json ReportOf(const ProgramResult& result) {
    EXPECT_EQ(result.status, 0) << result.err;
    return json::parse(result.out, nullptr, false);
  }

  static std::string HashesOf(const json& report) {
    return report.value("trace_hash", "none") + " " + report.value("state_hash", "none");
  }

  std::string Run(const Words& more = {}) const {
    return HashesOf(ReportOf(RunProgram(Flags(more))));
  }

  // The hashes of the same run, started by another program.
  std::string RunBy(const Words& starter) const {
    return HashesOf(ReportOf(Start(starter + Words{OPENR_PROGRAM} + Flags())));
  }

  const ScratchFolder stick_;
};

TEST_F(EqualRunsTest, AProgramThatSendsAddressesIsTheSameRunThreeTimes) {
  const json report = ReportOf(RunProgram(Flags()));
  EXPECT_EQ(report["findings"], json::array());
  EXPECT_GT(report["messages"], 200);
  EXPECT_EQ(Run(), HashesOf(report));
  EXPECT_EQ(Run(), HashesOf(report));
}

TEST_F(EqualRunsTest, TheRunIsTheSameInOtherProcesses) {
  const std::string alone = Run();
  EXPECT_EQ(Run({"--isolate", "Mirror"}), alone);
  EXPECT_EQ(Run({"--isolate", "Revealer"}), alone);
  EXPECT_EQ(Run({"--isolate", "Revealer", "--isolate", "Mirror"}), alone);
}

TEST_F(EqualRunsTest, AFindingAboutTheNetworkSettingsIsOneFindingInAllProcesses) {
  stick_.Write("OPEN-R/SYSTEM/CONF/WLANCONF.TXT", "NO_SUCH_KEY=1\n");
  const json alone = ReportOf(RunProgram(Flags()))["findings"];
  EXPECT_EQ(alone.size(), 1u) << alone;
  const Words apart = {"--isolate", "Revealer", "--isolate", "Mirror"};
  EXPECT_EQ(ReportOf(RunProgram(Flags(apart)))["findings"], alone);
}

TEST_F(EqualRunsTest, TheRunIsTheSameWithReceivedDataOnPagesOfTheirOwn) {
  const std::string strict = Run({"--strict"});
  EXPECT_EQ(Run({"--strict"}), strict);
  EXPECT_EQ(Run({"--strict", "--isolate", "Revealer", "--isolate", "Mirror"}), strict);
}

TEST_F(EqualRunsTest, TheRunIsTheSameWithoutAddressRandomisation) {
  if (Start({"/usr/bin/setarch", "-R", "/bin/true"}).status != 0)
    GTEST_SKIP() << "this machine does not let a program switch address randomisation off";
  EXPECT_EQ(RunBy({"/usr/bin/setarch", "-R"}), Run());
}

TEST_F(EqualRunsTest, TheRunIsTheSameWithAnotherEnvironmentAndLessAddressSpace) {
  const std::string plain = Run();
  EXPECT_EQ(RunBy({"/usr/bin/env", "-i", "A=" + std::string(10'000, 'a')}), plain);
  EXPECT_EQ(RunBy({"/bin/bash", "-c", "ulimit -v 4000000; exec \"$0\" \"$@\""}), plain);
  EXPECT_EQ(RunBy({"/bin/bash", "-c", "ulimit -s unlimited; exec \"$0\" \"$@\""}), plain);
}

TEST_F(EqualRunsTest, TheRunIsTheSameFromAnotherFolderByAnotherUser) {
  const std::string plain = Run();
  const ScratchFolder other;
  const std::string copy = other.File("a/much/longer/name/of/the/same/stick");
  std::filesystem::create_directories(copy);
  std::filesystem::copy(stick_.path(), copy, std::filesystem::copy_options::recursive);
  EXPECT_EQ(HashesOf(ReportOf(RunProgram(FlagsOf(copy, {})))), plain);
  const Words nobody = {"/usr/bin/setpriv", "--reuid", "65534",
                        "--regid",          "65534",   "--clear-groups"};
  if (getuid() != 0 || Start(nobody + Words{OPENR_PROGRAM, "version"}).status != 0)
    GTEST_SKIP() << "the program cannot be run by another user here";
  std::filesystem::permissions(stick_.path(), std::filesystem::perms::all);
  EXPECT_EQ(RunBy(nobody), plain);
}

TEST_F(EqualRunsTest, ARecordingReplaysInAnotherProcess) {
  const ScratchFolder folder;
  const std::string file = folder.File("recording");
  const std::string recorded = Run({"--record", file});
  EXPECT_EQ(recorded, Run());
  const ProgramResult replay = RunProgram({"replay", file, "--stick", stick_.path()});
  EXPECT_EQ(replay.status, 0) << replay.err;
}

TEST_F(EqualRunsTest, OtherAddressesAreAFindingOfTheProgramAndNoDifferenceOfTheRun) {
  const ProgramResult result = RunProgram(
      {"explore", "--stick", stick_.path(), "--verify", "--runs", "3", "--for", "1s", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const json found = json::parse(result.out, nullptr, false);
  EXPECT_EQ(found["differences"], 0);
  EXPECT_EQ(found["address_dependent"], 3);
  EXPECT_EQ(found["address_dependent_seeds"], json({1, 2, 3}));
  EXPECT_NE(result.err.find("finding: with 3 of these seeds the program does something else when "
                            "its memory lies at other addresses"),
            std::string::npos)
      << result.err;
}

TEST_F(EqualRunsTest, AnAddressOfTheHostIsNamedWithSubjectAndOffset) {
  stick_.Write("OPEN-R/MW/DATA/P/HOST.TXT", "");
  for (const Words& where : {Words{}, Words{"--isolate", "Revealer"}}) {
    const json report = ReportOf(RunProgram(Flags(where)));
    ASSERT_EQ(report["findings"].size(), 1u) << report["findings"];
    const json& finding = report["findings"][0];
    EXPECT_EQ(finding["object"], "Revealer");
    EXPECT_EQ(finding["severity"], "warning");
    EXPECT_EQ(
        finding["text"].get<std::string>().find(
            "the subject 'Revealer.Out.Bytes.S' sends an address of this process at offset 8"),
        0u)
        << finding;
  }
}

}  // namespace
}  // namespace openr_host
