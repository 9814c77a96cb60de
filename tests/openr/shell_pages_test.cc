// openr completion and openr man: what bash and man do with what they print.
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "cli/process.h"
#include "openr/commands/input_words.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/inputs.h"
#include "runtime/core/system.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

class CompletionTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!HasProgram("bash")) GTEST_SKIP() << "there is no bash";
    folder_.Write("openr.bash", RunProgram({"completion", "bash"}).out);
    folder_.Write("a file.MTN", "");
    std::filesystem::create_directory(folder_.File("stick"));
  }

  // Returns what bash offers for the last of the words, in a folder with a file and a folder.
  std::vector<std::string> Offered(const std::string& words) const {
    const std::string script =
        ". ./openr.bash; compopt() { :; }; COMP_WORDS=(" + words +
        "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _openr; printf '%s\\n' \"${COMPREPLY[@]}\"";
    const ProcessResult result =
        RunProcess({"bash", "-c", script}, {{}, folder_.path(), true, true});
    EXPECT_TRUE(result.good()) << result.output;
    std::vector<std::string> offered;
    std::istringstream lines(result.output);
    for (std::string line; std::getline(lines, line);)
      if (!line.empty()) offered.push_back(line);
    return offered;
  }

  const ScratchFolder folder_;
};

TEST_F(CompletionTest, CommandsAreOfferedAtEachLevel) {
  EXPECT_THAT(Offered("openr ru"), UnorderedElementsAre("run"));
  EXPECT_THAT(Offered("openr mtn pl"), UnorderedElementsAre("plot"));
  EXPECT_THAT(Offered("openr rc 127.0.0.1 mtn up"), UnorderedElementsAre("upload"));
  EXPECT_THAT(Offered("openr help rc mtn pl"), UnorderedElementsAre("play"));
  EXPECT_THAT(Offered("openr ''"), Contains("explore"));
}

TEST_F(CompletionTest, FlagsAreOfferedOfTheCommandAndNoOther) {
  EXPECT_THAT(Offered("openr run --panel"), UnorderedElementsAre("--panel", "--panel-port"));
  EXPECT_THAT(Offered("openr run --wi"), IsEmpty());
  EXPECT_THAT(Offered("openr join --child"), IsEmpty());  // not for people
}

TEST_F(CompletionTest, ValuesAreThoseOfTheFlag) {
  EXPECT_THAT(Offered("openr run --robot ''"), UnorderedElementsAre("ers210", "ers220", "ers7"));
  EXPECT_THAT(Offered("openr run --robot = ers7"), UnorderedElementsAre("ers7"));
  EXPECT_THAT(Offered("openr run --stick s"), UnorderedElementsAre("stick"));
  EXPECT_THAT(Offered("openr run --for ''"), IsEmpty());
  EXPECT_THAT(Offered("openr stick robot --flavour w"), UnorderedElementsAre("wlan", "wconsole"));
}

TEST_F(CompletionTest, WorldsAreThoseThatCameAlongAndFiles) {
  folder_.Write("my-world.json", "");
  EXPECT_THAT(Offered("openr run --world ''"),
              UnorderedElementsAre("corridor.json", "empty-room.json", "field-2004.json",
                                   "ramp-and-stairs.json", "my-world.json", "a file.MTN",
                                   "openr.bash", "stick"));
  EXPECT_THAT(Offered("openr explore --world ra"), UnorderedElementsAre("ramp-and-stairs.json"));
  // The help of the flag names the worlds, too.
  const std::string help = RunProgram({"help", "run"}).out;
  for (const std::string& world : Offered("openr run --world ''")) {
    if (!world.ends_with(".json") || world == "my-world.json") continue;
    EXPECT_THAT(help, HasSubstr(world));
  }
}

TEST_F(CompletionTest, JointsAreThoseOfTheModels) {
  EXPECT_THAT(Offered("openr rc 127.0.0.1 move LF_j"),
              UnorderedElementsAre("LF_j1", "LF_j2", "LF_j3"));
  EXPECT_THAT(Offered("openr plot run.mcap neck"),
              IsSupersetOf({"neck_pan", "neck_tilt", "neck_roll"}));
  EXPECT_THAT(Offered("openr poke default break LF_j1"), UnorderedElementsAre("LF_j1"));
  EXPECT_THAT(Offered("openr poke default press ch"), UnorderedElementsAre("chin"));
  EXPECT_THAT(Offered("openr model show ers2"), UnorderedElementsAre("ers210", "ers220"));
}

TEST_F(CompletionTest, AnInputFollowsTheNameOfARun) {
  EXPECT_THAT(Offered("openr poke ''"), IsEmpty());
  EXPECT_THAT(Offered("openr poke default pu"), UnorderedElementsAre("push", "put"));
  EXPECT_THAT(Offered("openr poke --robot 1 default pu"), UnorderedElementsAre("push", "put"));
  EXPECT_THAT(Offered("openr poke --robot = 1 default pu"), UnorderedElementsAre("push", "put"));
  EXPECT_THAT(Offered("openr poke --ro"), UnorderedElementsAre("--robot"));
}

TEST_F(CompletionTest, TheInputsThatAreOfferedAreThoseOfARun) {
  folder_.Write("a.events", "0s nosuch\n");
  const ProgramResult refused =
      RunProgram({"run", "--no-panel", "--events", folder_.File("a.events")});
  const std::string begin = "known are ";
  const size_t at = refused.err.find(begin);
  ASSERT_NE(at, std::string::npos) << refused.err;
  std::string known = refused.err.substr(at + begin.size());
  known.erase(known.find('\n'));
  EXPECT_EQ(fmt::format("{}", fmt::join(Offered("openr poke default ''"), ", ")), known);
}

// Returns the inputs that a robot with a body knows.
std::vector<std::string> UsagesOfInputs() {
  SimulationOptions options;
  options.body = "ideal";
  options.host_network = false;
  options.console = [](std::string_view) {};
  Simulation simulation(options);
  std::vector<std::string> usages;
  for (const Inputs::Kind* const kind : simulation.system().inputs().KindsOf(0))
    usages.push_back(kind->usage);
  return usages;
}

TEST_F(CompletionTest, AnInputIsFollowedByTheWordsOfItsUsage) {
  EXPECT_THAT(Offered("openr poke default push ''"), UnorderedElementsAre("at", "for"));
  EXPECT_THAT(Offered("openr poke default charger ''"), UnorderedElementsAre("on", "off"));
  EXPECT_THAT(Offered("openr poke default hold ''"), IsEmpty());
  EXPECT_THAT(Offered("openr poke default break neck_pan ja"), UnorderedElementsAre("jammed"));
  for (const std::string& usage : UsagesOfInputs()) {
    const std::string kind = usage.substr(0, usage.find(' '));
    const std::vector<std::string> offered = Offered("openr poke default " + kind + " ''");
    const std::set<std::string> words = WordsInUsage(usage);
    for (const std::string& word : words) {
      if (std::islower(static_cast<unsigned char>(word[0])) == 0) continue;
      EXPECT_THAT(offered, Contains(word)) << usage;
    }
    const auto offers = [&offered](const char* word) {
      return std::find(offered.begin(), offered.end(), word) != offered.end();
    };
    EXPECT_EQ(offers("LF_j1"), words.contains("JOINT")) << usage;
    EXPECT_EQ(offers("chin"), words.contains("SENSOR")) << usage;
    EXPECT_EQ(offers("jammed"), words.contains("FAULT")) << usage;
  }
}

TEST_F(CompletionTest, FilesAreOfferedWhereACommandTakesOne) {
  EXPECT_THAT(Offered("openr mtn info 'a'"), UnorderedElementsAre("a file.MTN"));
  EXPECT_THAT(Offered("openr build ''"), UnorderedElementsAre("stick"));
}

TEST(CompletionCommandTest, AShellThatIsNotKnownIsRefused) {
  const ProgramResult result = RunProgram({"completion", "fish"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("fish"));
}

class ManPageTest : public ::testing::Test {
 protected:
  void SetUp() override { EXPECT_EQ(RunProgram({"man", "-o", folder_.File("man1")}).status, 0); }

  // Returns a page as a person reads it.
  std::string Shown(const std::string& page) const {
    const ProcessResult result =
        RunProcess({"groff", "-man", "-Tascii", "-P-cbou", "-ww", folder_.File("man1/" + page)},
                   {{}, "", true, true});
    EXPECT_TRUE(result.good()) << result.output;
    return result.output;
  }

  const ScratchFolder folder_;
};

TEST_F(ManPageTest, ThereIsOneForTheProgramAndEachCommand) {
  for (const char* page : {"openr.1", "openr-run.1", "openr-rc.1", "openr-stick.1"})
    EXPECT_TRUE(std::filesystem::exists(folder_.File(std::string("man1/") + page))) << page;
}

TEST_F(ManPageTest, TheyAreFormattedWithoutComplaints) {
  if (!HasProgram("groff")) GTEST_SKIP() << "there is no groff";
  for (const auto& entry : std::filesystem::directory_iterator(folder_.File("man1"))) {
    const std::string text = Shown(entry.path().filename());
    EXPECT_THAT(text, Not(HasSubstr("warning:"))) << entry.path();
    EXPECT_THAT(text, HasSubstr("EXAMPLES")) << entry.path();
  }
}

TEST_F(ManPageTest, ThePageOfACommandHasItsFlagsAndTheCommandsBelow) {
  if (!HasProgram("groff")) GTEST_SKIP() << "there is no groff";
  EXPECT_THAT(Shown("openr-run.1"), HasSubstr("--until-idle"));
  const std::string rc = Shown("openr-rc.1");
  EXPECT_THAT(rc, HasSubstr("openr rc mtn play"));
  EXPECT_THAT(rc, HasSubstr("openr rc HOST mtn play [OPTIONS] FILE"));
  EXPECT_THAT(rc, HasSubstr("--loops"));
  EXPECT_THAT(Shown("openr.1"), HasSubstr("NO_COLOR"));
}

TEST_F(ManPageTest, AFolderThatCannotBeWrittenIsNamed) {
  folder_.Write("file", "");
  const ProgramResult result = RunProgram({"man", "-o", folder_.File("file/man1")});
  EXPECT_NE(result.status, 0);
  EXPECT_THAT(result.err, HasSubstr("file"));
}

}  // namespace
}  // namespace openr_host
