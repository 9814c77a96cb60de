// core.md 8.1 (terminal) and 10.1 23, field-notes.md section 6: objects that read the console.
#include "runtime/core/stalls.h"
#include "runtime/core/system_inputs.h"
#include "tests/conformance/conform_fixture.h"

namespace openr_host {
namespace {

class ConsoleConformance : public ConformTest {
 protected:
  // Returns the text that the object prints for `command` if a person then types `typed`.
  std::string Typing(const std::string& command, const std::string& typed) {
    Tell(command);
    TypeText(system.get(), 0, typed);
    system->RunFor(8000);
    return Said();
  }
};

TEST_F(ConsoleConformance, AReaderWaitsAloneUntilALineIsThere) {
  Start();
  EXPECT_EQ(Answer("gets"), "");
  Hear("assert");
  Tell("ready?");  // waits behind the reader
  EXPECT_EQ(Said(), "");
  EXPECT_EQ(DescribeWaits(*system).size(), 1u);
  TypeText(system.get(), 0, "some words\n");
  system->RunFor(8000);
  EXPECT_EQ(Said(), "some words\nT gets 'some words'\nT ready 1 refs 0\nT any 1 ready 1 all 1\n");
}

// The old object exists as long as its handler waits.
TEST_F(ConsoleConformance, AReaderThatWasReloadedUsesNoMemoryOfTheRobot) {
  Start();
  Tell("gets");
  system->object_table().Reload(IdOf("teller"));
  system->RunFor(
      25'000'000);  // DoStop and DoDestroy of the old object are given up after 10 s each
  size_t used = 0;
  for (const auto& object : system->objects()) {
    if (object->memory().arena() != nullptr) used += object->memory().arena()->bytes_in_use();
  }
  EXPECT_EQ(system->robot(0).memory.used_bytes, used);
}

TEST_F(ConsoleConformance, LinesEnterAtAFrameBoundary) {
  Start();
  Tell("gets");
  system->RunUntil(17'000);
  TypeText(system.get(), 0, "x");
  system->RunUntil(23'999);
  EXPECT_EQ(Said(), "");
  system->RunUntil(24'000);
  EXPECT_EQ(Said(), "x\nT gets 'x'\n");
}

TEST_F(ConsoleConformance, EveryWayToReadWorks) {
  Start();
  EXPECT_EQ(Typing("fgets", "a line\n"), "a line\nT fgets 'a line\n'\n");
  EXPECT_EQ(Typing("getchar", "ab\n"), "ab\nT getchar ab\n");
  EXPECT_EQ(Typing("gets", "next\n"), "T gets ''\n");  // the rest of the line before
  EXPECT_EQ(Answer("read"), "next\nT read 5\n");
  EXPECT_EQ(Typing("scanf", "4 -5\n"), "4 -5\nT scanf 2: 4 -5\n");
  EXPECT_EQ(Answer("gets"), "T gets ''\n");
  EXPECT_EQ(Typing("cin", "word 7 and more\n"), "word 7 and more\nT cin 'word' 7 ' and more'\n");
}

TEST_F(ConsoleConformance, LinesTypedAheadAreReadOneByOne) {
  Start();
  TypeText(system.get(), 0, "one\ntwo\n");
  system->RunFor(8000);
  EXPECT_EQ(Answer("gets"), "one\nT gets 'one'\n");
  EXPECT_EQ(Answer("gets"), "two\nT gets 'two'\n");
}

TEST_F(ConsoleConformance, OnlyTheThreeDescriptorsAreATerminal) {
  Start();
  EXPECT_EQ(Answer("isatty"), "T isatty 1 1 1 0\n");
}

TEST_F(ConsoleConformance, WhatIsTypedIsHeardByARecordingAndPartOfTheState) {
  Start();
  std::string heard;
  system->inputs().OnAdd(
      [&](int robot, std::string_view line) { heard += fmt::format("{}:{}", robot, line); });
  const uint64_t before = system->state_hash();
  TypeText(system.get(), 0, "secret");
  EXPECT_EQ(heard, "0:type secret");
  EXPECT_NE(system->state_hash(), before);
}

TEST_F(ConsoleConformance, TextIsRefusedWhileTooMuchTextWaitsUntilAProgramReads) {
  Start();
  std::string lines;
  while (lines.size() < ConsoleInput::kUnreadMax) lines += "1234567\n";
  EXPECT_EQ(TypeText(system.get(), 0, lines), "");
  const std::string refused =
      "type: no program of the robot reads the console: 65536 bytes of typed text wait already, "
      "and at most 65536 can wait; usage: type TEXT";
  EXPECT_EQ(TypeText(system.get(), 0, "x"), refused);  // the text before may wait for its frame
  system->RunFor(8000);
  EXPECT_EQ(TypeText(system.get(), 0, "x"), refused);
  EXPECT_EQ(system->inputs().Check(0, "type x"), refused);
  EXPECT_EQ(Answer("gets"), "1234567\nT gets '1234567'\n");
  EXPECT_EQ(system->inputs().Check(0, "type x"), "");  // checking keeps no room
  EXPECT_EQ(TypeText(system.get(), 0, "1234567"), "");
  EXPECT_EQ(TypeText(system.get(), 0, "x"), refused);
}

TEST_F(ConsoleConformance, ALineThatNoConsoleCanHoldIsRefused) {
  Start();
  EXPECT_EQ(TypeText(system.get(), 0, std::string(ConsoleInput::kUnreadMax, 'x')),
            "type: the text has 65537 bytes with its newline; at most 65536 can wait to be read; "
            "usage: type TEXT");
  EXPECT_EQ(TypeText(system.get(), 0, std::string(ConsoleInput::kUnreadMax - 1, 'x')), "");
}

TEST_F(ConsoleConformance, AReaderInDoStartGetsItsLine) {
  Data("TSTART.TXT", "gets\n");
  ASSERT_TRUE(Load());
  TypeText(system.get(), 0, "early");
  Boot();
  const std::string said = Said();
  EXPECT_NE(said.find("T gets 'early'\nH start\n"), std::string::npos) << said;
  EXPECT_EQ(Findings(), "");
}

}  // namespace
}  // namespace openr_host
