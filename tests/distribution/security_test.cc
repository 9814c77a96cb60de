// DDS Security: processes with certificates of one authority take part; others cannot join or
// listen.
#include <gmock/gmock.h>

#include <cstdlib>
#include <memory>

#include "distribution/dds_settings.h"
#include "tests/distribution/same_run.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

const Words kFlags = {"--for", "3s", "--body", "ideal"};

class SecurityTest : public testing::Test {
 protected:
  // Made once for all tests, because making keys takes time.
  static void SetUpTestSuite() {
    keys = std::make_unique<ScratchFolder>();
    for (const char* authority : {"ours", "theirs"}) {
      const std::string command = std::string(OPENR_DDS_SECURITY) + " " + keys->File(authority) +
                                  " alpha beta 2>" + keys->File("said");
      if (std::system(command.c_str()) == 0) continue;
      why_not = "settings cannot be made (openssl): " + keys->Read("said");
      return;
    }
    const ProgramResult result = RunProgram({"top", "--once", "--wait", "100ms", "--run-name",
                                             "nobody", "--dds-config", Settings("ours/alpha")});
    if (result.err.find("Could not load") != std::string::npos)
      why_not = "the plugins of Cyclone DDS are not installed: " + result.err;
  }
  static void TearDownTestSuite() { keys.reset(); }
  void SetUp() override {
    if (!why_not.empty()) GTEST_SKIP() << why_not;
    folder.Write("where.cfg", "Controller vision\nJointMover legs\n@vision 127.0.0.1\n");
  }

  static std::string Settings(const std::string& of) { return keys->File(of + ".xml"); }
  // The file of settings; "": none.
  static Words With(const std::string& settings) {
    return settings.empty() ? Words{} : Words{"--dds-config", Settings(settings)};
  }
  // Starts the worker with Controller.
  std::unique_ptr<ProgramRun> Join(const std::string& settings, const std::string& wait) const {
    return std::make_unique<ProgramRun>(
        Words{"join", "--process", "vision", "--run-name", name, "--wait", wait} + With(settings));
  }
  // Starts a run that itself starts a worker with JointMover.
  RecordedRun RunWithJoiner(const std::string& join_wait) const {
    return Record(kFlags + With("ours/alpha") +
                  Words{"--placement", folder.File("where.cfg"), "--run-name", name, "--join-wait",
                        join_wait});
  }

  static inline std::unique_ptr<ScratchFolder> keys;
  static inline std::string why_not;
  const ScratchFolder folder;
  const std::string name = "secret-" + std::to_string(getpid());
};

TEST_F(SecurityTest, ProcessesOfOneAuthorityMakeOneRun) {
  const auto join = Join("ours/beta", "60s");
  const RecordedRun run = RunWithJoiner("60s");
  EXPECT_EQ(join->Finish().status, 0) << join->heard();
  ExpectSame(Record(kFlags), run);
}

TEST_F(SecurityTest, AProcessOfAnotherAuthorityCannotJoin) {
  const auto open = Join("", "3s"), other = Join("theirs/beta", "3s");
  const RecordedRun run = RunWithJoiner("3s");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("process 'vision' did not come within 3 s"));
  for (const auto& intruder : {open.get(), other.get()}) {
    EXPECT_EQ(intruder->Finish().status, 1);
    EXPECT_THAT(intruder->heard(), HasSubstr("no run '" + name + "'"));
  }
}

TEST_F(SecurityTest, AProcessOfAnotherAuthorityCannotListen) {
  ProgramRun run(Words{"run", "--no-panel", "--rc-port", "0", "--body", "ideal", "--monitor",
                       "--run-name", name, "--dds-config", Settings("ours/alpha")});
  ASSERT_TRUE(run.WaitFor("state: listening"));
  const auto top = [this](const std::string& settings, const std::string& wait) {
    return std::make_unique<ProgramRun>(Words{"top", "--once", "--wait", wait, "--run-name", name} +
                                        With(settings));
  };
  const auto open = top("", "2s"), other = top("theirs/beta", "2s"), ours = top("ours/beta", "60s");
  EXPECT_EQ(ours->Finish().status, 0) << ours->heard();
  EXPECT_EQ(other->Finish().status, 1);
  EXPECT_EQ(open->Finish().status, 1);
}

// Topics of ROS 2 are protected as well.
TEST_F(SecurityTest, Ros2TopicsAreProtectedAsWell) {
  const ProgramResult result =
      RunProgram(kQuickly + Words{"--for", "1s", "--body", "ideal", "--ros2", "--dds-config",
                                  Settings("ours/alpha")});
  EXPECT_EQ(result.status, 0) << result.err;
}

// A missing file must be an error, since the run would not be protected.
TEST(SettingsTest, AMissingSettingsFileIsRefused) {
  const ScratchFolder folder;
  for (const std::string& file : {folder.path(), folder.File("nothing.xml")}) {
    const ProgramResult result =
        RunProgram({"run", "--for", "1s", "--isolate", "JointMover", "--dds-config", file});
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr("--dds-config " + file + ": "));
  }
}

class SettingsForADomainTest : public testing::Test {
 protected:
  std::string ProblemFor(const std::string& text, int domain) const {
    folder.Write("s.xml", text);
    return DomainProblem(folder.File("s.xml"), domain);
  }
  const ScratchFolder folder;
};

TEST_F(SettingsForADomainTest, SettingsForAnotherDomainAreReported) {
  const std::string seven =
      "<?xml version=\"1.0\"?><!-- <Domain id=\"0\"/> --><CycloneDDS>"
      "<Domain Id='7'><Tracing/></Domain></CycloneDDS>";
  EXPECT_EQ(ProblemFor(seven, 7), "");
  EXPECT_EQ(ProblemFor(seven, 0),
            "its settings are for domain 7, this is domain 0: they would be left out; write "
            "<Domain id=\"any\">, or give --dds-domain");
  EXPECT_EQ(ProblemFor("<CycloneDDS><Domain id=\"7\"/><Domain id=\"00\"/></CycloneDDS>", 0), "");
  for (const char* attribute : {"", " id=\"ANY\"", " id=\"${NOT_SET:-0}\""})
    EXPECT_EQ(ProblemFor(std::string("<CycloneDDS><Domain") + attribute + "/></CycloneDDS>", 0),
              "");
  EXPECT_NE(ProblemFor("<CycloneDDS><Domain><Id>7</Id></Domain></CycloneDDS>", 0), "");
  for (const char* nothing : {"<CycloneDDS/>", ""})
    EXPECT_EQ(ProblemFor(nothing, 0), "there are no settings in it");
}

TEST_F(SettingsForADomainTest, SecurityForAnotherDomainIsReported) {
  const std::string two =
      "<CycloneDDS><Domain><Tracing/></Domain>"
      "<Domain id=\"7\"><Security/></Domain></CycloneDDS>";
  EXPECT_EQ(ProblemFor(two, 7), "");
  EXPECT_EQ(ProblemFor("<CycloneDDS><Domain><DDSSecurity/></Domain>"  // an older name of <Security>
                       "<Domain id=\"7\"><Security/></Domain></CycloneDDS>",
                       0),
            "");
  EXPECT_THAT(ProblemFor(two, 0),
              HasSubstr("its <Security> is for domain 7, this is domain 0, which "
                        "would not be protected"));
}

TEST_F(SettingsForADomainTest, AnUnreadableFileIsLeftToCyclone) {
  EXPECT_EQ(ProblemFor("<CycloneDDS><Domain id=\"7\">", 0), "");
  EXPECT_EQ(DomainProblem(folder.File("nothing.xml"), 0), "");
}

TEST_F(SettingsForADomainTest, AllCommandsRefuseSettingsForAnotherDomain) {
  folder.Write("s.xml", "<CycloneDDS><Domain id=\"7\"/></CycloneDDS>");
  const Words flags = {"--dds-config", folder.File("s.xml"), "--dds-domain", "3"};
  for (const Words& command : {Words{"run", "--for", "1s", "--isolate", "JointMover"},
                               Words{"join", "--process", "vision"}, Words{"top", "--once"}}) {
    const ProgramResult result = RunProgram(command + flags);
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr("--dds-config " + folder.File("s.xml") +
                                      ": its settings are for domain 7, this is domain 3"));
  }
}

}  // namespace
}  // namespace openr_host
