// openr build --debug, --sanitize and --coverage, and openr coverage.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "kit/coverage.h"
#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

// The program Greeter with `statement` in its DoStart, on line 14 of Greeter.cc.
class Variant {
 public:
  Variant(const std::string& flag, const std::string& statement) : folder_("handmade") {
    std::string source = folder_.Read("Greeter/Greeter.cc");
    const std::string last = "    OSYSPRINT((\"handmade: start\\n\"));\n";
    source.replace(source.find(last), last.size(), statement + "\n");
    folder_.Write("Greeter/Greeter.cc", source);
    const ProgramResult built = folder_.Build({flag});
    EXPECT_EQ(built.status, 0) << built.err;
  }

  ProgramResult Run(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"run",    "--stick", folder_.File("MS"), "--for",     "100ms",
                                      "--rate", "max",     "--no-panel",       "--rc-port", "0"};
    words.insert(words.end(), more.begin(), more.end());
    return RunProgram(words);
  }
  const KitFolder& folder() const { return folder_; }

 private:
  const KitFolder folder_;
};

#if !defined(__SANITIZE_ADDRESS__)  // a program with sanitizers cannot load these images

TEST(VariantsTest, ARecordingIsReplayedWithTheLibraryThatItsImagesNeed) {
  const Variant program("--sanitize", "    volatile double sum = 0.5;\n    sum = sum + 1;");
  const std::string file = program.folder().File("run.rec");
  ASSERT_EQ(program.Run({"--record", file}).status, 0);
  const ProgramResult replayed = RunProgram({"replay", file});
  EXPECT_EQ(replayed.status, 0) << replayed.err;
  EXPECT_THAT(replayed.err, HasSubstr("equal, 0.100 s of virtual time"));
  const ProgramResult plotted =
      RunProgram({"plot", file, "neck_pan", "-o", program.folder().File("neck.svg")});
  EXPECT_EQ(plotted.status, 0) << plotted.err;
}

// An external worker learns from the run which stick it needs, unless --stick says so.
TEST(VariantsTest, AnExternalWorkerIsStartedAgainWithTheLibraryThatItsImagesNeed) {
  const Variant program("--sanitize", KitFolder::Printing("far away"));
  const std::string stick = program.folder().File("MS"), name = fmt::format("far-{}", getpid());
  program.folder().Write("where.cfg", "greeter far\n@far 127.0.0.1\n");
  for (const std::vector<std::string>& flags :
       {std::vector<std::string>{}, std::vector<std::string>{"--restart"},
        std::vector<std::string>{"--stick", stick}}) {
    std::vector<std::string> words = {"join", "--process", "far", "--run-name", name};
    words.insert(words.end(), flags.begin(), flags.end());
    ProgramRun join(words);
    ProgramRun run({"run", "--stick", stick, "--placement", program.folder().File("where.cfg"),
                    "--run-name", name, "--for", "100ms", "--rate", "max", "--no-panel",
                    "--rc-port", "0"});
    EXPECT_EQ(run.Finish().status, 0) << run.heard() << join.heard();
    EXPECT_THAT(run.heard(), HasSubstr("far away\n"));
    EXPECT_EQ(join.Finish().status, 0) << join.heard();
  }
}

TEST(VariantsTest, AHeapOverflowEndsTheRunAndNamesTheLine) {
  const Variant program(
      "--sanitize",
      "    volatile char* block = new char[10]; volatile int at = 10; block[at] = 1;");
  const ProgramResult result = program.Run();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("ERROR: AddressSanitizer: heap-buffer-overflow"));
  EXPECT_THAT(result.err, HasSubstr("crash: AddressSanitizer: heap-buffer-overflow"));
  EXPECT_THAT(result.err, HasSubstr("Greeter.cc:14"));
}

TEST(VariantsTest, ADoubleFreeIsReportedWhenItHappens) {
  const Variant program("--sanitize",
                        "    char* volatile block = new char[10]; delete[] block; delete[] block;");
  const ProgramResult result = program.Run();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("crash: AddressSanitizer: double-free"));
}

TEST(VariantsTest, AnOverflowOnTheStackEndsTheRun) {
  const Variant program("--sanitize",
                        "    char room[8]; volatile int at = 8; ((volatile char*)room)[at] = 1;");
  const ProgramResult result = program.Run();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("crash: AddressSanitizer: stack-buffer-overflow"));
}

// field-notes.md 9.2.  The same program runs on the robot for whose images its buffer is made.
TEST(VariantsTest, ABufferForImagesOfAnErs210IsTooSmallForThoseOfAnErs7) {
  const KitFolder folder("");
  std::filesystem::copy(std::string(OPENR_DOCS) + "/../examples/Camera", folder.File(""),
                        std::filesystem::copy_options::recursive);
  std::string source = folder.Read("Camera/Camera.cc");
  const std::string right = "new byte[3 * width_ * height_]";
  const size_t at = source.find(right);
  ASSERT_NE(at, std::string::npos);
  folder.Write("Camera/Camera.cc", source.replace(at, right.size(), "new byte[3 * 176 * 144]"));
  ASSERT_EQ(folder.Build({"--sanitize"}).status, 0);
  const auto run = [&](const std::string& robot) {
    return RunProgram({"run", "--stick", folder.File("MS"), "--robot", robot, "--for", "600ms",
                       "--rate", "max", "--no-panel", "--rc-port", "0"});
  };
  const ProgramResult good = run("ers210");
  EXPECT_EQ(good.status, 0) << good.err;
  EXPECT_THAT(good.err, HasSubstr("Camera: a picture of 176 x 144"));
  const ProgramResult bad = run("ers7");
  EXPECT_EQ(bad.status, 1);
  EXPECT_THAT(bad.err, HasSubstr("crash: AddressSanitizer: heap-buffer-overflow"));
  EXPECT_THAT(bad.err, ContainsRegex("in Camera::Convert.*Camera.cc:[0-9]+"));
}

TEST(VariantsTest, UndefinedBehaviourIsAFindingAndTheRunGoesOn) {
  const Variant program("--sanitize",
                        "    volatile int bits = 40; volatile int big = 2147483647;\n"
                        "    big = big + 1; bits = 1 << bits;");
  const ProgramResult result = program.Run();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("undefined behaviour at Greeter.cc:15: 2147483647 + 1 is too "
                                    "large for 'int'"));
  EXPECT_THAT(result.err, HasSubstr("1, a value of 'int', is shifted by 40 bits"));
}

TEST(VariantsTest, AGoodProgramHasNoFindingsWithSanitizers) {
  const Variant program("--sanitize", "    delete[] new char[10];");
  const ProgramResult result = program.Run();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("warning")));
  EXPECT_THAT(result.err, Not(HasSubstr("AddressSanitizer")));
}

#endif

TEST(VariantsTest, CoverageNamesTheLinesThatDidNotRun) {
  const Variant program("--coverage", "    if (&event == 0) {\n        return oFAIL;\n    }");
  ASSERT_EQ(program.Run().status, 0);
  const std::string folder = program.folder().File("");
  const ProgramResult shown = RunProgram({"coverage", folder});
  ASSERT_EQ(shown.status, 0) << shown.err;
  EXPECT_THAT(shown.out, ContainsRegex("lines  Greeter/Greeter.cc; not run: 15"));
  const std::string lcov = program.folder().scratch().File("greeter.info");
  const ProgramResult as_json = RunProgram({"coverage", folder, "--json", "--lcov", lcov});
  const auto report = nlohmann::json::parse(as_json.out);
  EXPECT_EQ(report["files"][0]["counts"]["14"], 1) << as_json.out;
  EXPECT_EQ(report["files"][0]["counts"]["15"], 0);
  EXPECT_THAT(program.folder().scratch().Read("greeter.info"), HasSubstr("DA:15,0\n"));
  ASSERT_EQ(RunProgram({"coverage", folder, "--reset"}).status, 0);
  EXPECT_THAT(RunProgram({"coverage", folder}).err, HasSubstr("no run has left counts"));
}

TEST(VariantsTest, CoverageOfAPlainBuildSaysWhatToDo) {
  const KitFolder folder("handmade");
  const ProgramResult result = RunProgram({"coverage", folder.File("")});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("was not built with --coverage; "));
}

TEST(VariantsTest, TwoVariantsAtOnceAreRefused) {
  const ProgramResult result = RunProgram({"build", "/tmp", "--debug", "--sanitize"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("--sanitize"));
}

TEST(VariantsTest, ClangIsRefusedForSanitizers) {
  const KitFolder folder("handmade");
  const NamedCompiler compiler("clang++");
  const ProgramResult result = folder.Build({"--sanitize"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("--sanitize needs g++"));
}

TEST(CoverageTest, NeighboursAreJoined) {
  EXPECT_EQ(LinesNotRun({{1, 1}, {3, 0}, {5, 2}, {7, 0}, {9, 0}}), "3, 7-9");
  EXPECT_EQ(LinesNotRun({{1, 1}}), "");
}

TEST(CoverageTest, CountsOfSeveralFilesAreAdded) {
  LineCounts counts;
  const std::string one =
      R"({"current_working_directory":"/a","files":[{"file":"b.cc","lines":[{"line_number":3,"count":2}]}]})";
  AddGcovCounts(one + "\n" + one + "\n", &counts);
  EXPECT_EQ(counts["/a/b.cc"][3], 4u);
  EXPECT_THROW(AddGcovCounts("usage\n", &counts), std::runtime_error);
}

}  // namespace
}  // namespace openr_host
