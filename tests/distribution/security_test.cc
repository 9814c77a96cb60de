// DDS Security: who has settings of the same authority takes part, others neither do nor hear.
#include <gmock/gmock.h>

#include <cstdlib>

#include "distribution/dds_settings.h"
#include "tests/distribution/same_run.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

const Words kFlags = {"--for", "3s", "--body", "ideal"};

class SecurityTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* authority : {"ours", "theirs"}) {
      const std::string command = std::string(OPENR_DDS_SECURITY) + " " + folder.File(authority) +
                                  " alpha beta 2>" + folder.File("said");
      if (std::system(command.c_str()) != 0)
        GTEST_SKIP() << "settings cannot be made (openssl): " << folder.Read("said");
    }
    const ProgramResult result = RunProgram({"top", "--once", "--wait", "100ms", "--run-name", name,
                                             "--dds-config", Settings("ours/alpha")});
    if (result.err.find("Could not load") != std::string::npos)
      GTEST_SKIP() << "the plugins of Cyclone DDS are not installed: " << result.err;
    folder.Write("where.cfg", "Controller vision\nJointMover legs\n@vision 127.0.0.1\n");
  }
  std::string Settings(const std::string& of) const { return folder.File(of + ".xml"); }

  // JointMover in a process that is started, Controller in one that joins; "": without settings.
  void RunAndJoin(const std::string& joins_with, RecordedRun* run, ProgramResult* join) const {
    Words words = {"join", "--process", "vision", "--run-name", name, "--wait", "3s"};
    if (!joins_with.empty()) words = words + Words{"--dds-config", Settings(joins_with)};
    ProgramRun joining(words);
    *run = Record(kFlags + Words{"--placement", folder.File("where.cfg"), "--run-name", name,
                                 "--join-wait", "3s", "--dds-config", Settings("ours/alpha")});
    *join = joining.Finish();
  }

  const ScratchFolder folder;
  const std::string name = "secret-" + std::to_string(getpid());
};

TEST_F(SecurityTest, WhoIsOfOneAuthorityIsOneRun) {
  RecordedRun run;
  ProgramResult join;
  RunAndJoin("ours/beta", &run, &join);
  EXPECT_EQ(join.status, 0) << join.err;
  ExpectSame(Record(kFlags), run);
}

TEST_F(SecurityTest, OthersAreNotLetIn) {
  for (const char* settings : {"", "theirs/beta"}) {
    SCOPED_TRACE(settings);
    RecordedRun run;
    ProgramResult join;
    RunAndJoin(settings, &run, &join);
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.err, HasSubstr("process 'vision' did not come within 3 s"));
    EXPECT_EQ(join.status, 1);
    EXPECT_THAT(join.err, HasSubstr("no run '" + name + "'"));
  }
}

TEST_F(SecurityTest, OthersDoNotHear) {
  ProgramRun run(Words{"run", "--no-panel", "--rc-port", "0", "--body", "ideal", "--monitor",
                       "--run-name", name, "--dds-config", Settings("ours/alpha")});
  ASSERT_TRUE(run.WaitFor("state: listening"));
  const Words top = {"top", "--once", "--wait", "2s", "--run-name", name};
  EXPECT_EQ(RunProgram(top + Words{"--dds-config", Settings("ours/beta")}).status, 0);
  EXPECT_EQ(RunProgram(top + Words{"--dds-config", Settings("theirs/beta")}).status, 1);
  EXPECT_EQ(RunProgram(top).status, 1);
}

// Topics of ROS 2 are protected as well.
TEST_F(SecurityTest, Ros2IsAllowed) {
  const ProgramResult result =
      RunProgram(kQuickly + Words{"--for", "1s", "--body", "ideal", "--ros2", "--dds-config",
                                  Settings("ours/alpha")});
  EXPECT_EQ(result.status, 0) << result.err;
}

// Without the file a run would not be protected.
TEST(SettingsTest, AreAFileThatIsThere) {
  const ScratchFolder folder;
  for (const std::string& file : {folder.path(), folder.File("nothing.xml")}) {
    const ProgramResult result =
        RunProgram({"run", "--for", "1s", "--isolate", "JointMover", "--dds-config", file});
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr("--dds-config: " + file + ": "));
  }
}

class SettingsForADomainTest : public testing::Test {
 protected:
  std::string Why(const std::string& text, int domain) const {
    folder.Write("s.xml", text);
    return WhyNotForDomain(folder.File("s.xml"), domain);
  }
  const ScratchFolder folder;
};

TEST_F(SettingsForADomainTest, AreReadInThatOneOnly) {
  const std::string seven =
      "<?xml version=\"1.0\"?><!-- <Domain id=\"0\"/> --><CycloneDDS>"
      "<Domain Id='7'><Tracing/></Domain></CycloneDDS>";
  EXPECT_EQ(Why(seven, 7), "");
  EXPECT_EQ(Why(seven, 0),
            "its settings are for domain 7, this is domain 0: they would be left out; write "
            "<Domain id=\"any\">, or give --dds-domain");
  EXPECT_EQ(Why("<CycloneDDS><Domain id=\"7\"/><Domain id=\"00\"/></CycloneDDS>", 0), "");
  for (const char* attribute : {"", " id=\"ANY\"", " id=\"${NOT_SET:-0}\""})
    EXPECT_EQ(Why(std::string("<CycloneDDS><Domain") + attribute + "/></CycloneDDS>", 0), "");
  EXPECT_NE(Why("<CycloneDDS><Domain><Id>7</Id></Domain></CycloneDDS>", 0), "");
  for (const char* nothing : {"<CycloneDDS/>", ""})
    EXPECT_EQ(Why(nothing, 0), "there are no settings in it");
}

TEST_F(SettingsForADomainTest, ProtectThatOneOnly) {
  const std::string two =
      "<CycloneDDS><Domain><Tracing/></Domain>"
      "<Domain id=\"7\"><Security/></Domain></CycloneDDS>";
  EXPECT_EQ(Why(two, 7), "");
  EXPECT_EQ(Why("<CycloneDDS><Domain><DDSSecurity/></Domain>"  // its older name
                "<Domain id=\"7\"><Security/></Domain></CycloneDDS>",
                0),
            "");
  EXPECT_THAT(Why(two, 0), HasSubstr("its <Security> is for domain 7, this is domain 0, which "
                                     "would not be protected"));
}

TEST_F(SettingsForADomainTest, ThatCannotBeReadAreLeftToCyclone) {
  EXPECT_EQ(Why("<CycloneDDS><Domain id=\"7\">", 0), "");
  EXPECT_EQ(WhyNotForDomain(folder.File("nothing.xml"), 0), "");
}

TEST_F(SettingsForADomainTest, AreRefusedByAllWhoTakeThem) {
  folder.Write("s.xml", "<CycloneDDS><Domain id=\"7\"/></CycloneDDS>");
  const Words flags = {"--dds-config", folder.File("s.xml"), "--dds-domain", "3"};
  for (const Words& command : {Words{"run", "--for", "1s", "--isolate", "JointMover"},
                               Words{"join", "--process", "vision"}, Words{"top", "--once"}}) {
    const ProgramResult result = RunProgram(command + flags);
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr("--dds-config: " + folder.File("s.xml") +
                                      ": its settings are for domain 7, this is domain 3"));
  }
}

}  // namespace
}  // namespace openr_host
