#include "kit/compile_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kit/link_command.h"
#include "kit/sdk_paths.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Arguments = std::vector<std::string>;

TEST(CompileCommandTest, FlagsForTheRobotsProcessorAreLeftOut) {
  const CompileCommand command =
      TranslateCompile({"-O2", "-mips3", "-EL", "-G", "0", "-G8", "-mno-abicalls", "-fno-pic", "-c",
                        "a.cc", "-o", "a.o"},
                       true);
  EXPECT_THAT(command.arguments, ElementsAre("-O2", "-c", "a.cc", "-o", "a.o"));
  EXPECT_EQ(command.output, "a.o");
  EXPECT_THAT(command.sources, ElementsAre("a.cc"));
  EXPECT_TRUE(command.compiles);
}

TEST(CompileCommandTest, WarningsAreNoErrors) {
  EXPECT_THAT(TranslateCompile({"-Wall", "-Werror", "-Werror=x", "-pedantic-errors", "-ansi"}, true)
                  .arguments,
              ElementsAre("-Wall"));
}

TEST(CompileCommandTest, ValuesOfFlagsAreNotTakenForFlags) {
  EXPECT_THAT(TranslateCompile({"-D", "-mips", "-include", "-w"}, true).arguments,
              ElementsAre("-D", "-mips", "-include", "-w"));
}

TEST(CompileCommandTest, TheOldWayToSplitTheSearchPathIsSaidInTodays) {
  EXPECT_THAT(TranslateCompile({"-Ia", "-I-", "-Ib", "-c", "x.cc"}, true).arguments,
              ElementsAre("-iquotea", "-Ib", "-c", "x.cc"));
}

TEST(CompileCommandTest, TheDriverAndTheFileDecideOnTheLanguage) {
  EXPECT_EQ(TranslateCompile({"-c", "a.c"}, false).language, Language::kC);
  EXPECT_EQ(TranslateCompile({"-c", "a.c"}, true).language, Language::kCxx);
  EXPECT_EQ(TranslateCompile({"-c", "a.cc"}, false).language, Language::kCxx);
  EXPECT_EQ(TranslateCompile({"-c", "-x", "c++", "a.c"}, false).language, Language::kCxx);
}

TEST(CompileCommandTest, PreprocessingIsNotCompiling) {
  EXPECT_FALSE(TranslateCompile({"-MM", "a.cc"}, true).compiles);
  EXPECT_FALSE(TranslateCompile({"--version"}, true).compiles);
}

TEST(CompileCommandTest, FlagsTheCompilerDoesNotKnowAreFoundInItsComplaint) {
  EXPECT_THAT(UnknownFlags("g++: error: unrecognized command-line option '-fold'\n"
                           "cc1plus: error: unrecognized command-line option '-Wodd=3'\n"),
              ElementsAre("-fold", "-Wodd=3"));
  EXPECT_THAT(UnknownFlags("clang: error: unknown argument: '-fold'\n"), ElementsAre("-fold"));
  EXPECT_THAT(UnknownFlags("a.cc:1:1: error: expected '-f'\n"), IsEmpty());
}

TEST(CompileCommandTest, FlagsOfTheListAreForALanguageAndACompiler) {
  const std::string text = "# comment\nall -a\nc++ -b\nc -c\nc++,gnu -d\nall,clang  -e\n";
  EXPECT_THAT(ParseCompileFlags(text, Language::kCxx, false), ElementsAre("-a", "-b", "-d"));
  EXPECT_THAT(ParseCompileFlags(text, Language::kC, true), ElementsAre("-a", "-c", "-e"));
}

TEST(LinkCommandTest, LibrariesOfTheSdkAreLeftToTheRuntime) {
  const LinkCommand command =
      TranslateMkbin({"-p", "/sdk", "-o", "x.bin", "a.o", "x.ocf", "b.o", "-Llib", "-L", "own",
                      "-lObjectComm", "-lmine", "libc.a", "--novm", "-m", "x.map", "-v"},
                     [](const std::string& file) { return file == "own/libmine.a"; });
  EXPECT_EQ(command.output, "x.bin");
  EXPECT_EQ(command.ocf, "x.ocf");
  EXPECT_EQ(command.map, "x.map");
  EXPECT_TRUE(command.is_verbose);
  EXPECT_THAT(command.objects, ElementsAre("a.o", "b.o"));
  EXPECT_THAT(command.libraries, ElementsAre("libc.a", "own/libmine.a"));
}

TEST(LinkCommandTest, UndefinedNamesAreListedOnce) {
  EXPECT_THAT(UndefinedNames("a.o: undefined reference to `Foo::Bar(int)'\n"
                             "b.o: undefined reference to `Foo::Bar(int)'\n"
                             "b.o: undefined reference to `x'\n"),
              ElementsAre("Foo::Bar(int)", "x"));
}

}  // namespace
}  // namespace openr_host
