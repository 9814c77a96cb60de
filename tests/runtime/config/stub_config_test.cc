#include "runtime/config/stub_config.h"

#include <gtest/gtest.h>

namespace openr_host::stub_config_test {
namespace {

StubConfigResult Parse(const std::string& text) { return ParseStubConfig("stub.cfg", text); }

// A valid file of 5 lines, to which tests append lines from line 6 on.
const std::string kGood =
    "ObjectName : Mover\n"
    "NumOfOSubject : 1\n"
    "NumOfOObserver : 1\n"
    "Service : \"Mover.Move.Data.S\", null, ReadyMove()\n"
    "Service : \"Mover.Stop.Data.O\", null, NotifyStop()\n";

// Returns the same file with other service lines, in lines 4 and 5.
std::string WithServices(const std::string& first, const std::string& second) {
  return "ObjectName : Mover\nNumOfOSubject : 1\nNumOfOObserver : 1\n" + first + "\n" + second +
         "\n";
}
const std::string kSubject = "Service : \"Mover.Move.Data.S\", null, ReadyMove()";
const std::string kObserver = "Service : \"Mover.Stop.Data.O\", null, NotifyStop()";

std::string Problems(const std::string& text) { return Render(Parse(text).diagnostics); }

// Returns all messages about a file whose 4th line, a subject's, is `line`.
std::string ProblemsOfSubject(const std::string& line) {
  return Problems(WithServices(line, kObserver));
}

TEST(StubConfigTest, GoodFileIsRead) {
  const StubConfigResult result = Parse(kGood);
  EXPECT_EQ(Render(result.diagnostics), "");
  EXPECT_EQ(result.config.object_name, "Mover");
  ASSERT_EQ(result.config.subjects.size(), 1u);
  EXPECT_EQ(Compose(result.config.subjects[0].name), "Mover.Move.Data.S");
  EXPECT_EQ(result.config.subjects[0].connect_function, "");
  EXPECT_EQ(result.config.subjects[0].data_function, "ReadyMove");
  EXPECT_EQ(result.config.subjects[0].place.line, 4);
  EXPECT_EQ(result.config.subjects[0].place.column, 12);
  ASSERT_EQ(result.config.observers.size(), 1u);
  EXPECT_EQ(result.config.observers[0].data_function, "NotifyStop");
  EXPECT_EQ(result.config.NumOfSelectors(), 8);
}

TEST(StubConfigTest, CrLfTabsAndMissingNewlineMakeNoDifference) {
  const StubConfigResult result = Parse(
      "ObjectName:Mover\r\n\tNumOfOSubject\t:\t1\r\nNumOfOObserver:1 \r\n"
      "Service:\"Mover.Move.Data.S\",null,ReadyMove()\r\n"
      "  Service  :  \"Mover.Stop.Data.O\"   , Connect () , NotifyStop\t()  ");
  EXPECT_EQ(Render(result.diagnostics), "");
  EXPECT_EQ(result.config.object_name, "Mover");
  EXPECT_EQ(result.config.subjects[0].data_function, "ReadyMove");
  EXPECT_EQ(result.config.observers[0].connect_function, "Connect");
  EXPECT_EQ(result.config.observers[0].data_function, "NotifyStop");
}

TEST(StubConfigTest, CountKeywordsHaveTwoSpellings) {
  EXPECT_EQ(Problems("ObjectName : Mover\nNumOfSubject : 1\nNumOfObserver : 1\n" + kSubject + "\n" +
                     kObserver),
            "");
}

TEST(StubConfigTest, AnyOtherLineIsAComment) {
  EXPECT_EQ(Problems("// stub.cfg of Mover\n# also\nServices follow below\n\n   \n-- Extra care "
                     "is needed\n" +
                     kGood + "//Service : \"A.B.C.S\", null\n"),
            "");
}

TEST(StubConfigTest, RestOfNameAndCountLinesIsIgnored) {
  EXPECT_EQ(Problems("ObjectName : Mover // class\nNumOfOSubject : 1 one\nNumOfOObserver : 1;\n" +
                     kSubject + "\n" + kObserver + "\nExtra : Tick() // every second\n"),
            "");
}

TEST(StubConfigTest, CountsMayFollowTheServices) {
  EXPECT_EQ(Problems(kSubject + "\n" + kObserver +
                     "\nNumOfOObserver : 1\nNumOfOSubject : 1\nObjectName : Mover\n"),
            "");
}

TEST(StubConfigTest, SubjectsAndObserversAreNumberedApartInFileOrder) {
  const StubConfigResult result = Parse(
      "ObjectName : A\nNumOfOSubject : 2\nNumOfOObserver : 2\n"
      "Service : \"A.o0.T.O\", null, null\nService : \"A.s0.T.S\", null, null\n"
      "Service : \"A.s1.T.S\", null, null\nService : \"A.o1.T.O\", null, null\n");
  EXPECT_EQ(Render(result.diagnostics), "");
  EXPECT_EQ(result.config.subjects[0].name.short_name, "s0");
  EXPECT_EQ(result.config.subjects[1].name.short_name, "s1");
  EXPECT_EQ(result.config.observers[0].name.short_name, "o0");
  EXPECT_EQ(result.config.observers[1].name.short_name, "o1");
}

TEST(StubConfigTest, ObjectPartOfAServiceNeedNotBeTheObjectName) {
  EXPECT_EQ(ProblemsOfSubject("Service : \"Mover1.Move.Data.S\", null, null"), "");
}

TEST(StubConfigTest, SubjectAndObserverMayShareAName) {
  EXPECT_EQ(Problems(WithServices("Service : \"M.Move.T.S\", null, null",
                                  "Service : \"M.Move.T.O\", null, null")),
            "");
}

TEST(StubConfigTest, OneFunctionMayServeSeveralServices) {
  EXPECT_EQ(Problems(WithServices("Service : \"M.Move.T.S\", F(), F()",
                                  "Service : \"M.Stop.T.O\", F(), F()")),
            "");
}

TEST(StubConfigTest, ExtrasComeInFileOrder) {
  const StubConfigResult result = Parse(kGood + "Extra : Tick()\nExtra:Tock()\n");
  ASSERT_EQ(result.config.extras.size(), 2u);
  EXPECT_EQ(result.config.extras[0].function, "Tick");
  EXPECT_EQ(result.config.extras[1].function, "Tock");
  EXPECT_EQ(result.config.NumOfSelectors(), 10);
}

TEST(StubConfigTest, FunctionWithoutBracketsIsRefused) {
  EXPECT_EQ(
      ProblemsOfSubject(R"(Service : "Mover.Move.Data.S", null, ReadyMove)"),
      R"(stub.cfg:4: function 'ReadyMove' has no '()'; write ReadyMove(), or null for no function
Service : "Mover.Move.Data.S", null, ReadyMove
                                     ^
)");
}

TEST(StubConfigTest, NullInCapitalsIsRefused) {
  EXPECT_EQ(ProblemsOfSubject(R"(Service : "Mover.Move.Data.S", NULL, null)"),
            R"(stub.cfg:4: 'NULL' has no '()'; write null in lower case for no function
Service : "Mover.Move.Data.S", NULL, null
                               ^
)");
}

TEST(StubConfigTest, BlankBetweenTheBracketsIsRefused) {
  EXPECT_EQ(ProblemsOfSubject(R"(Service : "Mover.Move.Data.S", null, F( ))"),
            R"(stub.cfg:4: write F() with nothing between the brackets, not even a blank
Service : "Mover.Move.Data.S", null, F( )
                                      ^
)");
}

TEST(StubConfigTest, TrailingCommentIsRefused) {
  EXPECT_EQ(ProblemsOfSubject(R"(Service : "Mover.Move.Data.S", null, F() // go)"),
            R"(stub.cfg:4: '// go' after F(); a comment needs a line of its own
Service : "Mover.Move.Data.S", null, F() // go
                                         ^
)");
}

TEST(StubConfigTest, TrailingSemicolonIsRefused) {
  EXPECT_EQ(ProblemsOfSubject(R"(Service : "Mover.Move.Data.S", null, F();)"),
            R"(stub.cfg:4: ';' after F(); remove it
Service : "Mover.Move.Data.S", null, F();
                                        ^
)");
}

TEST(StubConfigTest, WordAfterNullIsRefused) {
  EXPECT_EQ(ProblemsOfSubject(R"(Service : "Mover.Move.Data.S", null, null // dummy)"),
            R"(stub.cfg:4: '// dummy' after null; a comment needs a line of its own
Service : "Mover.Move.Data.S", null, null // dummy
                                          ^
)");
}

TEST(StubConfigTest, MissingSecondFunctionIsRefused) {
  EXPECT_EQ(ProblemsOfSubject(R"(Service : "Mover.Move.Data.S", null)"),
            R"(stub.cfg:4: second function (ready) is missing; write ', Name()' or ', null'
Service : "Mover.Move.Data.S", null
                                   ^
)");
}

TEST(StubConfigTest, ThirdFunctionIsRefused) {
  EXPECT_EQ(ProblemsOfSubject(R"(Service : "Mover.Move.Data.S", null, F(), G())"),
            R"(stub.cfg:4: more than two functions; a service has two
Service : "Mover.Move.Data.S", null, F(), G()
                                        ^
)");
}

TEST(StubConfigTest, MissingFunctionsAreRefused) {
  EXPECT_EQ(ProblemsOfSubject("Service : \"Mover.Move.Data.S\""),
            "stub.cfg:4: comma and two functions must follow the name; write null for no "
            "function\n"
            "Service : \"Mover.Move.Data.S\"\n"
            "                             ^\n");
}

TEST(StubConfigTest, EmptyFunctionIsRefused) {
  EXPECT_EQ(ProblemsOfSubject(R"(Service : "Mover.Move.Data.S", , null)"),
            R"(stub.cfg:4: function is missing; write Name(), or null for no function
Service : "Mover.Move.Data.S", , null
                               ^
)");
}

TEST(StubConfigTest, FunctionThatIsNoNameIsRefused) {
  EXPECT_EQ(ProblemsOfSubject(R"(Service : "Mover.Move.Data.S", 0, null)"),
            R"(stub.cfg:4: '0' is not a function; write Name(), or null for none
Service : "Mover.Move.Data.S", 0, null
                               ^
)");
}

TEST(StubConfigTest, ServiceWithABadNameIsIgnoredAndTheCountSaysSo) {
  EXPECT_EQ(ProblemsOfSubject("Service : \"Mover.Move.S\", null, null"),
            "stub.cfg:4: warning: line ignored: 'Mover.Move.S' has 3 parts, a service name has 4: "
            "Object.Service.Data.S for a subject, .O for an observer\n"
            "Service : \"Mover.Move.S\", null, null\n"
            "           ^\n"
            "stub.cfg:2: NumOfOSubject is 1, but the file has 0 subjects; line 4 was ignored\n"
            "NumOfOSubject : 1\n"
            "                ^\n");
}

TEST(StubConfigTest, ServiceWithALowerCaseDirectionIsIgnored) {
  const StubConfigResult result = Parse(kGood + "Service : \"Mover.More.Data.s\", null, null\n");
  EXPECT_EQ(
      Render(result.diagnostics),
      R"(stub.cfg:6: warning: line ignored: 'Mover.More.Data.s' ends in '.s'; a subject ends in '.S', an observer in '.O'; did you mean '.S'?
Service : "Mover.More.Data.s", null, null
                           ^
)");
  EXPECT_EQ(result.config.subjects.size(), 1u);
}

TEST(StubConfigTest, ServiceWithoutQuotesIsIgnoredWithAWarning) {
  EXPECT_EQ(Problems(kGood + "Service : Mover.More.Data.S, null, null\n"),
            "stub.cfg:6: warning: line ignored: service name without quotes; write Service : "
            "\"Object.Service.Data.S\", Function(), Function()\n"
            "Service : Mover.More.Data.S, null, null\n"
            "          ^\n");
}

TEST(StubConfigTest, ServiceWithOneQuoteIsIgnoredWithAWarning) {
  EXPECT_EQ(Problems(kGood + "Service : \"Mover.More.Data.S, null, null\n"),
            "stub.cfg:6: warning: line ignored: closing quote is missing; write Service : "
            "\"Object.Service.Data.S\", Function(), Function()\n"
            "Service : \"Mover.More.Data.S, null, null\n"
            "          ^\n");
}

TEST(StubConfigTest, MisspeltKeywordIsIgnoredWithAWarning) {
  EXPECT_EQ(Problems(kGood + "Extras : Tick()\n"),
            "stub.cfg:6: warning: line ignored: no keyword 'Extras'; did you mean 'Extra'?\n"
            "Extras : Tick()\n"
            "^\n");
}

TEST(StubConfigTest, KeywordInOtherCaseIsIgnoredWithAWarning) {
  EXPECT_EQ(Problems(kGood + "service : \"A.B.C.S\", null, null\n"),
            "stub.cfg:6: warning: line ignored: no keyword 'service'; did you mean 'Service'?\n"
            "service : \"A.B.C.S\", null, null\n"
            "^\n");
}

TEST(StubConfigTest, KeywordWithoutColonIsIgnoredWithAWarning) {
  EXPECT_EQ(Problems(kGood + " Extra Tick()\n"),
            "stub.cfg:6: warning: line ignored: no ':' after 'Extra'; write 'Extra : ...', or '//' "
            "before a comment\n"
            " Extra Tick()\n"
            " ^\n");
}

TEST(StubConfigTest, ProseWithAColonGivesNoWarning) {
  EXPECT_EQ(Problems(kGood + "Note: this is version 2\nExtra care: none\n"), "");
}

TEST(StubConfigTest, LineInsideABlockCommentHoldsWithAWarning) {
  EXPECT_EQ(Problems(kGood + "/* old\nExtra : Tick()\n*/\nExtra : Tock()\n"),
            "stub.cfg:7: warning: line holds although it is between /* and */; put '//' before it\n"
            "Extra : Tick()\n"
            "^\n");
}

TEST(StubConfigTest, ZeroSubjectsAreRefusedWithTheDummyToAdd) {
  EXPECT_EQ(Problems("ObjectName : Mover\nNumOfOSubject : 0\nNumOfOObserver : 1\n" + kObserver),
            "stub.cfg:2: NumOfOSubject is 0; every object needs at least one subject, add: Service "
            ": \"Mover.DummySubject.DoNotConnect.S\", null, null, and write 1 here\n"
            "NumOfOSubject : 0\n"
            "                ^\n");
}

TEST(StubConfigTest, ZeroObserversAreRefusedWithTheDummyToAdd) {
  EXPECT_EQ(Problems("ObjectName : Mover\nNumOfSubject : 1\nNumOfObserver : 0\n" + kSubject),
            "stub.cfg:3: NumOfObserver is 0; every object needs at least one observer, add: "
            "Service : \"Mover.DummyObserver.DoNotConnect.O\", null, null, and write 1 here\n"
            "NumOfObserver : 0\n"
            "                ^\n");
}

TEST(StubConfigTest, CountTooHighIsRefused) {
  EXPECT_EQ(Problems("ObjectName : Mover\nNumOfOSubject : 2\nNumOfOObserver : 1\n" + kSubject +
                     "\n" + kObserver),
            "stub.cfg:2: NumOfOSubject is 2, but the file has 1 subject; correct the number or add "
            "the missing Service line\n"
            "NumOfOSubject : 2\n"
            "                ^\n");
}

TEST(StubConfigTest, CountTooLowIsRefused) {
  EXPECT_EQ(Problems(kGood + "Service : \"Mover.More.Data.O\", null, null\n"),
            "stub.cfg:3: NumOfOObserver is 1, but the file has 2 observers; correct the number\n"
            "NumOfOObserver : 1\n"
            "                 ^\n");
}

TEST(StubConfigTest, BadFunctionDoesNotUpsetTheCounts) {
  EXPECT_EQ(Parse(WithServices("Service : \"M.Move.T.S\", null, F", kObserver)).diagnostics.size(),
            1u);
}

TEST(StubConfigTest, MissingLinesAreNamedWithWhatToAdd) {
  EXPECT_EQ(Problems(kSubject + "\n"),
            "stub.cfg: no ObjectName line; add: ObjectName : <the object's C++ class>\n"
            "stub.cfg: no NumOfOSubject line; add: NumOfOSubject : 1\n"
            "stub.cfg: no NumOfOObserver line; add: NumOfOObserver : 1; every object needs at "
            "least one observer, add: Service : \"Object.DummyObserver.DoNotConnect.O\", null, "
            "null\n");
}

TEST(StubConfigTest, CountThatIsNoNumberIsRefused) {
  for (const char* value : {"", "one", "-1", "99999999999"}) {
    SCOPED_TRACE(value);
    const std::string line = std::string("NumOfOSubject : ") + value;
    EXPECT_EQ(Problems("ObjectName : Mover\n" + line + "\nNumOfOObserver : 1\n" + kSubject + "\n" +
                       kObserver),
              "stub.cfg:2: NumOfOSubject needs a number of services, such as 1\n" + line +
                  "\n                ^\n");
  }
}

TEST(StubConfigTest, ObjectNameMustBeAClassName) {
  EXPECT_EQ(Problems("ObjectName : 2Legs\nNumOfOSubject : 1\nNumOfOObserver : 1\n" + kSubject +
                     "\n" + kObserver),
            "stub.cfg:1: '2Legs' is not the name of a C++ class; use letters, digits and '_'\n"
            "ObjectName : 2Legs\n"
            "             ^\n");
}

TEST(StubConfigTest, EmptyObjectNameIsRefused) {
  EXPECT_EQ(Problems("ObjectName :\nNumOfOSubject : 1\nNumOfOObserver : 1\n" + kSubject + "\n" +
                     kObserver),
            "stub.cfg:1: ObjectName without a name; write the object's C++ class\n"
            "ObjectName :\n"
            "            ^\n");
}

TEST(StubConfigTest, SecondObjectNameHoldsWithAWarning) {
  const StubConfigResult result = Parse(kGood + "ObjectName : Other\n");
  EXPECT_EQ(result.config.object_name, "Other");
  EXPECT_EQ(Render(result.diagnostics),
            "stub.cfg:6: warning: ObjectName again, after line 1; this line holds\n"
            "ObjectName : Other\n"
            "             ^\n");
}

TEST(StubConfigTest, SameServiceTwiceOnOneSideIsRefused) {
  const std::string text =
      "ObjectName : M\nNumOfOSubject : 2\nNumOfOObserver : 1\n" + kObserver +
      "\nService : \"M.Move.T.S\", null, null\nService : \"M.Move.U.S\", null, null\n";
  EXPECT_EQ(Problems(text),
            "stub.cfg:6: a second subject 'Move', after line 5: both would be sbjMove; rename one\n"
            "Service : \"M.Move.U.S\", null, null\n"
            "           ^\n");
}

TEST(StubConfigTest, ServiceThatCannotBePartOfACppNameIsRefused) {
  EXPECT_EQ(ProblemsOfSubject("Service : \"Mover.Move-2.Data.S\", null, null"),
            "stub.cfg:4: 'Move-2' cannot be part of the C++ name sbjMove-2; use letters, digits "
            "and '_' only\n"
            "Service : \"Mover.Move-2.Data.S\", null, null\n"
            "                 ^\n");
}

TEST(StubConfigTest, BlankInAServiceNameIsRefused) {
  EXPECT_EQ(ProblemsOfSubject("Service : \" Mover.Move.Data.S\", null, null"),
            "stub.cfg:4: blank in a service name; no line of CONNECT.CFG could name it\n"
            "Service : \" Mover.Move.Data.S\", null, null\n"
            "           ^\n");
}

TEST(StubConfigTest, OverlongServiceNameIsRefused) {
  const std::string object(128 - 12, 'M');
  const std::string line = "Service : \"" + object + ".Move.Data.S\", null, null";
  EXPECT_EQ(
      ProblemsOfSubject(line),
      "stub.cfg:4: service name of 128 characters, the limit is 127\n" + line + "\n           ^\n");
}

TEST(StubConfigTest, BlankBeforeTheBracketsOfAnExtraIsRefused) {
  EXPECT_EQ(Problems(kGood + "Extra : Tick ()\n"),
            "stub.cfg:6: function 'Tick' must be followed by '()' at once; write Extra : Tick()\n"
            "Extra : Tick ()\n"
            "        ^\n");
}

TEST(StubConfigTest, ExtraThatIsNoFunctionIsRefused) {
  EXPECT_EQ(Problems(kGood + "Extra : 1()\nExtra :\n"),
            "stub.cfg:6: '1()' is not a function; write Extra : Name()\n"
            "Extra : 1()\n"
            "        ^\n"
            "stub.cfg:7: Extra without a function; write Extra : Name()\n"
            "Extra :\n"
            "       ^\n");
}

TEST(StubConfigTest, SameExtraTwiceIsRefused) {
  EXPECT_EQ(Problems(kGood + "Extra : Tick()\nExtra : Tick()\n"),
            "stub.cfg:7: Extra Tick() again, after line 6; remove one\n"
            "Extra : Tick()\n"
            "        ^\n");
}

TEST(StubConfigTest, ExtraWithTheNameOfAnEntryIsRefused) {
  for (const char* name :
       {"Init", "Destroy", "Ready", "Control0", "Ready0", "Connect0", "Notify0"}) {
    SCOPED_TRACE(name);
    const std::string line = std::string("Extra : ") + name + "()\n";
    EXPECT_EQ(Problems(kGood + line), std::string("stub.cfg:6: Extra ") + name + "() would be _" +
                                          name + " in the stub, which is taken; rename it\n" +
                                          line + "        ^\n");
  }
  EXPECT_EQ(Problems(kGood + "Extra : Ready1()\n"), "");
}

TEST(StubConfigTest, MoreEntriesThanTheRobotHasSelectorsAreAWarning) {
  std::string text = kGood;
  for (int i = 0; i < 56; ++i) text += "Extra : Tick" + std::to_string(i) + "()\n";
  EXPECT_EQ(Problems(text), "");
  EXPECT_EQ(Problems(text + "Extra : Tock()\n"),
            "stub.cfg:1: warning: 65 entry points, the robot has 64 selectors for an object\n"
            "ObjectName : Mover\n"
            "             ^\n");
}

TEST(StubConfigTest, AllMistakesAreReportedNotOnlyTheFirst) {
  EXPECT_EQ(Parse(WithServices("Service : \"M.Move.T.S\", F, G", "Service : \"M.S.T.O\", H"))
                .diagnostics.size(),
            4u);
}

TEST(StubConfigTest, EmptyFileLacksThreeLines) { EXPECT_EQ(Parse("").diagnostics.size(), 3u); }

}  // namespace
}  // namespace openr_host::stub_config_test
