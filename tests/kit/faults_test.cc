// Tests that a program that `openr build` has built names the line in its own files when it does
// what stops the robot.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

#if !defined(__SANITIZE_ADDRESS__)  // AddressSanitizer reports such faults itself

// The program Greeter with `statement` in its DoStart, on line 14 of Greeter.cc; built as its
// makefile would, without a word about debug information.
class FaultyProgram {
 public:
  explicit FaultyProgram(const std::string& statement) : folder_("handmade") {
    std::string source = folder_.Read("Greeter/Greeter.cc");
    const std::string last = "    OSYSPRINT((\"handmade: start\\n\"));\n";
    source.replace(source.find(last), last.size(), statement + "\n");
    folder_.Write("Greeter/Greeter.cc", source);
    const ProgramResult built = folder_.Build();
    EXPECT_EQ(built.status, 0) << built.err;
  }

  ProgramResult Run(std::vector<std::string> flags = {}) const {
    flags.insert(flags.begin(), {"run", "--stick", folder_.File("MS"), "--for", "100ms", "--rate",
                                 "max", "--no-panel", "--rc-port", "0"});
    return RunProgram(flags);
  }

 private:
  const KitFolder folder_;
};

TEST(BuiltFaultsTest, AnObjectWithMoreThan64SelectorsDoesNotBoot) {
  const KitFolder folder("handmade");
  const auto run_with = [&](int selector) {
    std::string entries = folder.Read("Greeter/GreeterEntries.cc");
    const size_t end = entries.find("    { UNDEF, ");
    entries.insert(end, fmt::format("    {{ {}, (Entry)StopEntry }},\n", selector));
    folder.Write("Greeter/GreeterEntries.cc", entries);
    EXPECT_EQ(folder.Build().status, 0);
    return RunProgram({"run", "--stick", folder.File("MS"), "--for", "100ms", "--rate", "max",
                       "--no-panel", "--rc-port", "0"});
  };
  EXPECT_EQ(run_with(63).status, 0);
  const ProgramResult result = run_with(64);
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("selector out of range: sel=64, size=64; an object has 4"));
  EXPECT_THAT(result.err, HasSubstr("ended by no-boot"));
}

TEST(BuiltFaultsTest, ACrashNamesTheLine) {
  const ProgramResult result = FaultyProgram("    *(volatile int*)16 = 1;").Run();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("Greeter::DoStart(OSystemEvent const&) (Greeter.cc:14)"));
}

// field-notes.md, 1.8: the next macro uses subjects and observers that are not there.
TEST(BuiltFaultsTest, SubjectsAndObserversThatNobodyMadeAreACrashThatNamesTheLine) {
  const KitFolder folder("convention");
  std::string source = folder.Read("Counter/Counter.cc");
  const std::string macro = "NEW_ALL_SUBJECT_AND_OBSERVER;";
  ASSERT_NE(source.find(macro), std::string::npos);
  source.erase(source.find(macro), macro.size());
  folder.Write("Counter/Counter.cc", source);
  ASSERT_EQ(folder.Build().status, 0);
  const ProgramResult result = RunProgram({"run", "--stick", folder.File("MS"), "--for", "100ms",
                                           "--rate", "max", "--no-panel", "--rc-port", "0"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("EXCEPTION SIGSEGV (an address that is not the object's)"));
  // SET_ALL_READY_AND_NOTIFY_ENTRY
  EXPECT_THAT(result.err, HasSubstr("Counter::DoInit(OSystemEvent const&) (Counter.cc:10)"));
}

// Replaces `before` in the file `name` of `folder`, which must have it.
void Replace(const KitFolder& folder, const std::string& name, const std::string& before,
             const std::string& now) {
  std::string text = folder.Read(name);
  const size_t at = text.find(before);
  ASSERT_NE(at, std::string::npos) << before;
  folder.Write(name, text.replace(at, before.size(), now));
}

// field-notes.md 3.5.  In one process such a write only damages the other object, as it may on the
// robot.
TEST(BuiltFaultsTest, AWriteIntoMemoryOfAnotherObjectIsACrashOfTheWriterWhenItRunsAlone) {
  const KitFolder folder("makefile");
  const std::string stdio = "#include <stdio.h>\n";
  folder.Write("Sender/Sender.cc", stdio + folder.Read("Sender/Sender.cc"));
  folder.Write("Receiver/Receiver.cc", stdio + folder.Read("Receiver/Receiver.cc"));
  Replace(folder, "Sender/Sender.cc", "    Greet(line, ++sent);",
          "    static int victim = 1;\n    sprintf(line, \"%p\", (void*)&victim);\n"
          "    if (sent++ > 0) OSYSPRINT((\"victim is %d\\n\", victim));");
  Replace(folder, "Receiver/Receiver.cc",
          "    OSYSPRINT((\"heard: %s\\n\", (const char*)event.Data(0)));",
          "    void* place = 0;\n    sscanf((const char*)event.Data(0), \"%p\", &place);\n"
          "    *(int*)place = 99;");
  ASSERT_EQ(folder.Build().status, 0);
  const auto run = [&](const std::vector<std::string>& flags) {
    std::vector<std::string> words = {"run",    "--stick", folder.File("MS"), "--for",     "100ms",
                                      "--rate", "max",     "--no-panel",      "--rc-port", "0"};
    words.insert(words.end(), flags.begin(), flags.end());
    return RunProgram(words);
  };
  const ProgramResult together = run({});
  EXPECT_EQ(together.status, 0) << together.err;
  EXPECT_THAT(together.err, HasSubstr("victim is 99"));
  const ProgramResult apart = run({"--isolate", "receiver"});
  EXPECT_EQ(apart.status, 1);
  EXPECT_THAT(apart.err, ContainsRegex("error: receiver .*crash: SIGSEGV \\(an address that is not "
                                       "the object's\\).*Receiver::Notify.*Receiver.cc:[0-9]+"));
  EXPECT_THAT(apart.err, HasSubstr("victim is 1"));
  EXPECT_THAT(apart.err, Not(HasSubstr("victim is 99")));
}

TEST(BuiltFaultsTest, ANaNNamesTheLine) {
  const ProgramResult result =
      FaultyProgram("    volatile double zero = 0; zero = zero / zero;").Run();
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.err, HasSubstr("DoStart, at Greeter.cc:14: a floating-point operation made"));
}

TEST(BuiltFaultsTest, AnUnalignedAccessIsCheckedInEveryImageAndStrictlyTheEnd) {
  const FaultyProgram program(
      "    static char room[8]; char* volatile odd = room + 1; *(int*)odd = 1;");
  const ProgramResult result = program.Run();
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.err, ContainsRegex("warning: greeter .*unaligned access to 'int'.* at "
                                        "Greeter.cc:14"));
  const ProgramResult strict = program.Run({"--strict"});
  EXPECT_EQ(strict.status, 1);
  EXPECT_THAT(strict.err, HasSubstr("EXCEPTION unaligned access to 'int'"));
}

TEST(BuiltFaultsTest, MemoryThatLeaksAwayNamesTheLine) {
  const ProgramResult result =
      FaultyProgram("    while (new char[65536] != 0 && &event != 0) {}").Run({"--strict"});
  EXPECT_THAT(result.err, ContainsRegex("no memory for 65536 bytes, at Greeter.cc:14"));
}

#endif

}  // namespace
}  // namespace openr_host
