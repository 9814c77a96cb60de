// openr check: each mistake of the developer board that can be seen without running.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "runtime/core/image_file.h"
#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kConf[] = "MS/OPEN-R/MW/CONF/";

std::string Checked(const KitFolder& folder, int status = 1) {
  const ProgramResult result = RunProgram({"check", folder.File("")});
  EXPECT_EQ(result.status, status) << result.out << result.err;
  return result.out;
}

// A line of the output that begins with `place` and says `text`.
MATCHER_P2(Says, place, text, "") {
  std::istringstream lines(arg);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(place) != std::string::npos && line.find(text) != std::string::npos) return true;
  }
  return false;
}

TEST(CheckTest, AGoodProgramHasNoErrorsAndNoWarnings) {
  EXPECT_THAT(Checked(KitFolder("makefile"), 0), HasSubstr("0 errors, 0 warnings, 3 notes\n"));
}

TEST(CheckTest, JsonHoldsTheSameAndNothingElse) {
  const KitFolder folder("handmade");
  const ProgramResult result = RunProgram({"check", "--json", folder.File("")});
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["errors"], 0);
  EXPECT_EQ(json["notes"], 2);
  EXPECT_EQ(json["remarks"][0]["severity"], "note");
  EXPECT_EQ(json["remarks"][0]["line"], 1);
}

TEST(CheckTest, AnImageThatIsNotThereStopsTheRobot) {
  const KitFolder folder("makefile");
  folder.Write(std::string(kConf) + "OBJECT.CFG",
               "/MS/OPEN-R/MW/OBJS/SENDER.BIN\n/MS/OPEN-R/MW/OBJS/RECEIVER.BIN\n"
               "/MS/OPEN-R/MW/OBJS/NOTHERE.BIN\n");
  const std::string text = Checked(folder);
  EXPECT_THAT(text, Says("OBJECT.CFG:3:", "does not exist on the stick; the robot stops"));
  EXPECT_THAT(text, Says("OBJECT.CFG:", "note: no POWERMON.BIN"));
}

// field-notes.md, 2.6 and 2.7.
TEST(CheckTest, DataThatDoNotSurviveBeingCopiedAsBytes) {
  const KitFolder folder("makefile");
  folder.Write("common/Data.h",
               "struct Plain { int a; char text[20]; int Size(char* p); };\n"
               "struct Named : public Plain { std::string name; };\n"
               "struct Linked { int a; Linked* next; };\n"
               "class Shape { public: virtual ~Shape(); int a; };\n");
  const auto check = [&](const std::string& body) {
    folder.Write("Sender/More.cc",
                 "#include \"../common/Data.h\"\nvoid More() {\n" + body + "\n}\n");
    return Checked(folder, 0);
  };
  EXPECT_THAT(check("    Plain data; subject[0]->SetData(&data, sizeof(data));"),
              HasSubstr("0 warnings"));
  EXPECT_THAT(check("    Named data; subject[0]->SetData(&data, sizeof(data));"),
              Says("Sender/More.cc:3:",
                   "Named has a member of type string; SetData() sends the "
                   "bytes of it"));
  EXPECT_THAT(check("    Linked data = {1, 0};\n    subject[0]->SetData( &data, sizeof data );"),
              Says("Sender/More.cc:4:", "Linked has a pointer: Linked* next"));
  EXPECT_THAT(check("    subject[0]->SetData(&shape_, sizeof(Shape));"),
              Says("Sender/More.cc:3:", "Shape has virtual functions"));
  EXPECT_THAT(check("    // Named data; SetData(&data, sizeof(data));"), HasSubstr("0 warnings"));
}

// Only data members are sent.
TEST(CheckTest, AFunctionThatReturnsAPointerIsNoPointerInTheData) {
  const KitFolder folder("makefile");
  const std::string send =
      "void More() { Named data; subject[0]->SetData(&data, sizeof(data)); }\n";
  for (const char* member : {"char* Text();", "std::string Text();", "char* Text() { return 0; };",
                             "char* operator[](int i);"}) {
    folder.Write("Sender/More.cc",
                 std::string("struct Named { int a; ") + member + " int b; };\n" + send);
    EXPECT_THAT(Checked(folder, 0), HasSubstr("0 warnings")) << member;
  }
  folder.Write("Sender/More.cc",
               "struct Named { int Size() { return 0; } struct { int a; } *next; };\n" + send);
  EXPECT_THAT(Checked(folder, 0), HasSubstr("Named has a pointer"));
}

TEST(CheckTest, ALongLineAndALongFunctionInAStructAreChecked) {
  const KitFolder folder("makefile");
  const std::string text(200'000, 'x');
  folder.Write("Sender/More.cc", "const char* const text =\n\"" + text + "\";\n");
  EXPECT_THAT(Checked(folder, 0), HasSubstr("0 warnings"));
  folder.Write("Sender/More.cc",
               "struct Named { int a; int Size() const { return sizeof(\"" + text + "\"); } };\n");
  EXPECT_THAT(Checked(folder, 0), HasSubstr("0 warnings"));
  for (const std::string& type :
       {"struct Named  // " + text + "\n{ int a; };\n",
        "struct Named { int a;\n  int Size() const { return 0; }  // " + text + "\n};\n"}) {
    folder.Write("Sender/More.cc", type);
    EXPECT_THAT(Checked(folder, 0), HasSubstr("0 warnings"));
  }
  const KitFolder without_stub("handmade");
  without_stub.Write("Greeter/Text.cc", "const char* const text = \"" + text + "\";\n");
  EXPECT_THAT(Checked(without_stub, 0), HasSubstr("0 warnings"));
}

// field-notes.md, 2.7.
TEST(CheckTest, AVirtualFunctionCalledInAReceivedRegionIsFound) {
  const KitFolder folder("makefile");
  folder.Write("common/Shape.h",
               "class Shape { public: virtual ~Shape(); virtual int Area() const = 0; int a; };\n"
               "class Circle : public Shape { public: int Area() const; int Radius() const; };\n");
  const auto check = [&](const std::string& sender, const std::string& receiver) {
    folder.Write("Sender/More.cc",
                 "#include \"../common/Shape.h\"\nvoid More() {\n" + sender + "\n}");
    folder.Write("Receiver/More.cc", "void More(const ONotifyEvent& event) {\n" + receiver + "\n}");
    return Checked(folder, 0);
  };
  const std::string placed = "    new (region[i]->Base()) Circle(2);\n";
  const std::string sent = "    subject[0]->SetData(region[i]);";
  const std::string called = "    const Shape* s = (const Shape*)event.Data(0);\n    s->Area();";
  EXPECT_THAT(check(placed + sent, called),
              Says("Sender/More.cc:3:",
                   "warning: Circle has virtual functions, and More.cc calls Area() of received "
                   "data; the table of them is in the sender's image, so that call crashes on the "
                   "robot"));
  EXPECT_THAT(check(placed + sent, "    ((Circle*)event.RCData(0)->Base())->Area();"),
              Says("Sender/More.cc:3:", "More.cc calls Area() of received data"));
  EXPECT_THAT(
      check("    new ((void*)region->Base()) Circle(2); subject[0]->SetData(region);", called),
      Says("Sender/More.cc:3:", "Circle has virtual functions"));
  // Programs that worked on the robot.
  const std::string read = "    const Circle* s = (const Circle*)event.Data(0);\n    s->Radius();";
  EXPECT_THAT(check(placed + sent, read), HasSubstr("0 warnings"));
  const std::string own =
      "    const Shape* s = (const Shape*)event.Data(0);\n    table->Area(s->a);";
  EXPECT_THAT(check(placed + sent, own), HasSubstr("0 warnings"));
  EXPECT_THAT(check(placed, called), HasSubstr("0 warnings"));
  // The call is in the image of the sender, which has the table.
  EXPECT_THAT(check(placed + sent + called, ""), HasSubstr("0 warnings"));
}

TEST(CheckTest, SectionsOfSeveralRobotsMayNameTheSameImage) {
  const KitFolder folder("handmade");
  ASSERT_EQ(folder.Build().status, 0);
  folder.Write(std::string(kConf) + "OBJECT.CFG",
               "[ERS-210]\n/MS/OPEN-R/MW/OBJS/HANDMADE.BIN\n"
               "[ERS-7]\n/MS/OPEN-R/MW/OBJS/HANDMADE.BIN\n");
  EXPECT_THAT(Checked(folder, 0), HasSubstr("0 errors"));
}

TEST(CheckTest, AFileThatIsNoImageForThisMachineIsSaidSo) {
  const KitFolder folder("makefile");
  folder.Write("MS/OPEN-R/MW/OBJS/SENDER.BIN", "text");
  EXPECT_THAT(Checked(folder), Says("OBJECT.CFG:2:", "is not an object image"));
}

TEST(CheckTest, AServiceThatNobodyHasIsNotFound) {
  const KitFolder folder("makefile");
  folder.Write(std::string(kConf) + "CONNECT.CFG",
               "Sender.Txt.char.S Receiver.Text.char.O\n"
               "Sender.Text.int.S Receiver.Text.int.O\n");
  const std::string text = Checked(folder);
  EXPECT_THAT(text, Says("CONNECT.CFG:1:",
                         "NOT FOUND, the line is skipped; did you mean "
                         "'Sender.Text.char.S'?"));
  EXPECT_THAT(text, Says("CONNECT.CFG:2:", "has the data type 'char' in Sender, not 'int'"));
}

TEST(CheckTest, TheRobotsServicesAreKnown) {
  const KitFolder folder("makefile");
  folder.Write(std::string(kConf) + "CONNECT.CFG",
               "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S "
               "Receiver.Text.OSensorFrameVectorData.O\n");
  const std::string text = Checked(folder);
  EXPECT_THAT(text, Not(HasSubstr("no object on this stick has 'OVirtualRobotComm")));
}

TEST(CheckTest, AServiceConnectedToNothingIsNotedUnlessItSaysSo) {
  const KitFolder folder("makefile");
  folder.Write(std::string(kConf) + "CONNECT.CFG", "");
  const std::string text = Checked(folder, 0);
  EXPECT_THAT(text, Says("Sender/stub.cfg:4:", "note: CONNECT.CFG does not mention"));
  EXPECT_THAT(text, Not(HasSubstr("DummyObserver")));
}

TEST(CheckTest, ForgottenMacrosAreFound) {
  const KitFolder folder("makefile");
  folder.Write("Receiver/Receiver.cc",
               "#include \"Receiver.h\"\nvoid Receiver::Notify(const ONotifyEvent&) {}\n"
               "// REGISTER_ALL_ENTRY; AssertReady\n");
  const std::string text = Checked(folder, 0);
  EXPECT_THAT(text, Says("Receiver/stub.cfg:5:", "no REGISTER_ALL_ENTRY in DoInit"));
  EXPECT_THAT(text, Says("Receiver/stub.cfg:5:", "AssertReady is never called: Notify() will not"));
}

// field-notes.md, 1.8.
TEST(CheckTest, SubjectsAndObserversThatNobodyMakesAreFound) {
  const KitFolder folder("makefile");
  std::string source = folder.Read("Receiver/Receiver.cc");
  const std::string macro = "NEW_ALL_SUBJECT_AND_OBSERVER;";
  ASSERT_NE(source.find(macro), std::string::npos);
  source.erase(source.find(macro), macro.size());
  constexpr char kWarning[] = "no NEW_ALL_SUBJECT_AND_OBSERVER in DoInit: subject[] and observer[]";
  EXPECT_THAT(Checked(folder, 0), Not(HasSubstr(kWarning)));
  folder.Write("Receiver/Receiver.cc", source);
  const std::string text = Checked(folder, 0);
  EXPECT_THAT(text, Says("Receiver/stub.cfg:5:", kWarning));
  EXPECT_THAT(text, Not(HasSubstr("no REGISTER_ALL_ENTRY")));
}

TEST(CheckTest, AFunctionOfTheStubThatNobodyWroteIsNamed) {
  const KitFolder folder("convention");
  folder.Write("Counter/stub.cfg",
               "ObjectName : Countr\nNumOfOSubject : 1\nNumOfOObserver : 1\n"
               "Service : \"Counter.Number.char.S\", null, Redy()\n"
               "Service : \"Counter.D.DoNotConnect.O\", null, null\n");
  const std::string text = Checked(folder);
  EXPECT_THAT(text, Says("stub.cfg:1:", "the stub includes \"Countr.h\""));
  EXPECT_THAT(text, Says("stub.cfg:4:", "no Redy() in the sources of Counter"));
}

TEST(CheckTest, OddValuesAndEqualNamesInOcfFilesAreFound) {
  const KitFolder folder("makefile");
  folder.Write("Sender/sender.ocf", "object chat 3072 16386 128 cache tlb user\n");
  folder.Write("Receiver/receiver.ocf", "object chat 512 16384 128 cache tlb user\n");
  const std::string text = Checked(folder, 0);
  EXPECT_THAT(text, Says("sender.ocf:1:", "did you mean 16384?"));
  EXPECT_THAT(text, Says("receiver.ocf:1:", "a stack of 512 bytes"));
  EXPECT_THAT(text, Says("sender.ocf:1:", "an object is named 'chat'"));
}

// field-notes.md, 3.7: both numbers were made larger at every crash.
TEST(CheckTest, AHeapStepThatTheRobotHasNoRoomForIsFound) {
  const KitFolder folder("makefile");
  folder.Write("Sender/sender.ocf", "object sender 3072 33554432 128 cache tlb user\n");
  EXPECT_THAT(Checked(folder, 0), Says("sender.ocf:1:",
                                       "warning: the heap grows by 33554432 bytes at a time, the "
                                       "robot has 32 MB in all"));
  folder.Write("Sender/sender.ocf", "object sender 65536 1048576 128 cache tlb user\n");
  EXPECT_THAT(Checked(folder, 0), HasSubstr("0 warnings"));
}

TEST(CheckTest, NamesThatNoStickHoldsAreFoundOnItAndInSources) {
  const KitFolder folder("makefile");
  folder.Write("MS/OPEN-R/MW/DATA/P/motions-of-today.mtn", "");
  folder.Write("Sender/More.cc",
               "#include <stdio.h>\nvoid More() { fopen(\"/MS/OPEN-R/MW/DATA/P/LONGNAME1.TXT\", "
               "\"r\"); }\n");
  const std::string text = Checked(folder, 0);
  EXPECT_THAT(text, Says("motions-of-today.mtn:", "is not an 8.3 name"));
  EXPECT_THAT(text, Says("More.cc:2:", "'LONGNAME1.TXT' is not an 8.3 name"));
}

// field-notes.md, 1.11.
TEST(CheckTest, ThreadsOfAnObjectAreFound) {
  const KitFolder folder("makefile");
  folder.Write("Sender/More.cc",
               "#include <pthread.h>\n"
               "void More() { pthread_create(&thread, 0, Work, 0); }\n"
               "void Most() { std::thread worker(Work); }\n");
  const std::string text = Checked(folder, 0);
  EXPECT_THAT(text,
              Says("Sender/More.cc:2:", "warning: pthread_create(): the robot has no threads"));
  EXPECT_THAT(text, Says("Sender/More.cc:3:", "warning: std::thread(): the robot has no threads"));
  // Code that is not compiled for the robot.
  folder.Write("Sender/More.cc",
               "#ifdef PLATFORM_LOCAL\n#  if 1\nvoid More() { pthread_create(&thread, 0, Work, 0); "
               "}\n#  endif\nvoid Most() { std::thread worker(Work); }\n#endif\n"
               "// pthread_create(&thread, 0, Work, 0);\n");
  EXPECT_THAT(Checked(folder, 0), HasSubstr("0 warnings"));
}

// The text of the fixture's Sender.cc with `now` in place of `before`.
std::string SenderWith(const std::string& before, const std::string& now) {
  std::ifstream file(std::string(OPENR_KIT_FIXTURES) + "/makefile/Sender/Sender.cc");
  std::string source((std::istreambuf_iterator<char>(file)), {});
  const size_t at = source.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return at == std::string::npos ? source : source.replace(at, before.size(), now);
}

// field-notes.md, 2.12.
TEST(CheckTest, AnIndexThatStubCfgDoesNotMakeIsNamed) {
  const KitFolder folder("makefile");
  const std::string source = SenderWith("sbjText]->N", "sbjTxt]->N");
  folder.Write("Sender/Sender.cc", source);
  EXPECT_THAT(Checked(folder, 0),
              Says("Sender/Sender.cc:49:",
                   "warning: sbjTxt comes from no line of stub.cfg: stubgen2 makes it of the "
                   "service Txt in Service : \"Sender.Txt.TYPE.S\"; did you mean 'sbjText'?"));
  // Programs that have the name from elsewhere.
  for (const char* own : {"const int sbjTxt = 0;\n", "#define sbjTxt 0\n", "enum { sbjTxt };\n",
                          "enum Index { sbjOther = 3, sbjTxt };\n"}) {
    folder.Write("Sender/Sender.cc", own + source);
    EXPECT_THAT(Checked(folder, 0), HasSubstr("0 warnings")) << own;
  }
  folder.Write("Sender/Sender.cc", source);
  folder.Write("Sender/stub7.cfg", "Service : \"Sender.Txt.char.S\", null, Ready()\n");
  EXPECT_THAT(Checked(folder, 0), HasSubstr("0 warnings"));
}

TEST(CheckTest, AnIndexInASourceThatNobodyCompilesIsNoMistake) {
  const KitFolder folder("makefile");
  folder.Write("Sender/OldSender.cc", "void Old() { subject[sbjOld]->NotifyObservers(); }\n");
  EXPECT_THAT(Checked(folder, 0), HasSubstr("0 warnings"));
  folder.Write("Sender/Sender.cc",
               SenderWith("Sender::Sender()",
                          "#ifdef PLATFORM_LOCAL\nvoid Old() { subject[sbjOld]->NotifyObservers(); "
                          "}\n#endif\n// subject[sbjOld]\nSender::Sender()"));
  EXPECT_THAT(Checked(folder, 0), HasSubstr("0 warnings"));
}

// field-notes.md, 11.1: the example that Sony's guide prints.
TEST(CheckTest, AnEntryThatIsGivenInPlaceOfItsSelectorIsNamed) {
  const KitFolder folder("makefile");
  folder.Write("Sender/stub.cfg", folder.Read("Sender/stub.cfg") + "\nExtra : ListenCont()\n");
  const auto check = [&](const std::string& head, const std::string& line) {
    folder.Write("Sender/Sender.cc",
                 head + SenderWith("    char line[32];", line + "\n    char line[32];") +
                     "void Sender::ListenCont(void* msg) {}\n");
    return Checked(folder, 0);
  };
  EXPECT_THAT(check("", "    listen.Send(ipstack, myOID_, entryListenCont, sizeof(listen));"),
              Says("Sender/Sender.cc:46:",
                   "warning: entryListenCont is the place of ListenCont() in Extra_Entry[] and no "
                   "selector (selector 0 is DoInit, 1 is DoStart): write "
                   "Extra_Entry[entryListenCont]"));
  EXPECT_THAT(check("", "    OServiceEntry entry(myOID_,\n        entryListenCont);"),
              HasSubstr("and no selector"));
  // Programs that worked on the robot.
  for (const char* good :
       {"    listen.Send(ipstack, myOID_, Extra_Entry[entryListenCont], sizeof(listen));",
        "    Note(entryListenCont, 1); if (entryListenCont == 0) return;",
        "    listen.Send(ipstack, myOID_, entryOther, sizeof(listen));"}) {
    EXPECT_THAT(check("", good), HasSubstr("0 warnings")) << good;
  }
  EXPECT_THAT(check("enum { entryOther, entryListenCont };\n",
                    "    listen.Send(ipstack, myOID_, entryListenCont, sizeof(listen));"),
              HasSubstr("0 warnings"));
  EXPECT_THAT(check("static const Selector entryListenCont = 8;\n",
                    "    listen.Send(ipstack, myOID_, entryListenCont, sizeof(listen));"),
              HasSubstr("0 warnings"));
}

// field-notes.md, 6.4.
TEST(CheckTest, ConsoleMacrosWithOnePairOfBracketsAreNamed) {
  const KitFolder folder("makefile");
  const auto check = [&](const std::string& head, const std::string& line) {
    folder.Write("Sender/Sender.cc",
                 head + SenderWith("    char line[32];", line + "\n    char line[32];"));
    return Checked(folder, 0);
  };
  EXPECT_THAT(check("", "    OSYSPRINT(\"sent %d\\n\", sent);"),
              Says("Sender/Sender.cc:46:",
                   "warning: OSYSPRINT is a macro that needs two pairs of brackets: "
                   "OSYSPRINT((\"text %d\\n\", number));"));
  EXPECT_THAT(check("", "    OSYSLOG1(osyslogERROR, \"no\");"),
              Says("Sender/Sender.cc:46:", "OSYSLOG1((osyslogERROR, \"text %d\\n\", number));"));
  EXPECT_THAT(check("", "    OSYSDEBUG(\"%d\", f(1, 2));"), HasSubstr("OSYSDEBUG is a macro"));
  // Programs that worked on the robot.
  for (const char* good : {"    OSYSPRINT(( \"sent %d\\n\", sent ));", "    OSYSPRINT((\"a\"));",
                           "    OSYSDEBUG(\"no comma, and switched off\");",
                           "    // OSYSPRINT(\"sent\");", "    OSYSPRINT(arguments);"}) {
    EXPECT_THAT(check("", good), HasSubstr("0 warnings")) << good;
  }
  EXPECT_THAT(
      check("#undef OSYSPRINT\n#define OSYSPRINT(x) (osysprint(x))\n", "    OSYSPRINT(\"sent\");"),
      HasSubstr("0 warnings"));
}

// field-notes.md, 12.1.
TEST(CheckTest, ClocksThatTheRobotLacksAreNamed) {
  const KitFolder folder("makefile");
  const auto check = [&](const std::string& head, const std::string& line) {
    folder.Write("Sender/Sender.cc",
                 head + SenderWith("    char line[32];", line + "\n    char line[32];"));
    return Checked(folder, 0);
  };
  EXPECT_THAT(check("", "    gettimeofday(&tv, 0); long us = tv.tv_usec;"),
              Says("Sender/Sender.cc:46:",
                   "warning: gettimeofday(): on the robot the part below the second is always the "
                   "same (field-notes.md 12.1); here it is virtual time; take GetSystemTime()"));
  EXPECT_THAT(check("", "    long begin = clock();"),
              Says("Sender/Sender.cc:46:", "warning: clock(): the robot has no such clock"));
  EXPECT_THAT(check("", "    last = std::time(NULL);"), HasSubstr("time(): the robot has no such"));
  // Programs that worked on the robot: the seconds of gettimeofday(), a seed of random numbers, and
  // functions of their own under these names.
  for (const char* good :
       {"    gettimeofday(&tv, 0); long s = tv.tv_sec;", "    srand(time(NULL));",
        "    unsigned seed = time(0); srand(seed);", "    unsigned seed(time(0)); srand(seed + 1);",
        "    gettimeofday(&tv, 0); srandom(tv.tv_usec);", "    timer.clock(); timer->time(0);",
        "    MyTimer::clock();", "    long (*clock)() = Ticks; clock();",
        "    seed ^= time(0); srand(seed);", "    seed += clock(); srand(seed);"}) {
    EXPECT_THAT(check("", good), HasSubstr("0 warnings")) << good;
  }
  // Only the seed may be a clock.
  EXPECT_THAT(check("", "    srand(time(0)); seed = 1;\n    last = time(0);"),
              AllOf(Says("Sender/Sender.cc:47:", "warning: time(): the robot has no such clock"),
                    HasSubstr("1 warning")));
  EXPECT_THAT(check("", "    srand(seed); long begin = clock();"),
              HasSubstr("clock(): the robot has no such"));
  EXPECT_THAT(check("", "    if (last == time(0)) srand(last);"),
              HasSubstr("time(): the robot has no such"));
  EXPECT_THAT(check("static long time(long* t) { return 0; }\n", "    time(0);"),
              HasSubstr("0 warnings"));
  EXPECT_THAT(check("struct Probe {\n  int ticks, clock;\n  Probe() : ticks(0), clock() {}\n};\n"
                    "#include <vector>\nstruct Watch {\n  std::vector<int> time;\n"
                    "  Watch() : time(0) {}\n};\n",
                    ""),
              HasSubstr("0 warnings"));
}

// field-notes.md, 3.6.
TEST(CheckTest, TheSizeOfFreeMemoryThatMisleadsIsNamed) {
  const KitFolder folder("makefile");
  folder.Write("Sender/Sender.cc", SenderWith("    char line[32];",
                                              "    AnalyzerGetSizeOfFreeMemory(&bytes);\n"
                                              "    char line[32];"));
  EXPECT_THAT(Checked(folder, 0),
              Says("Sender/Sender.cc:46:",
                   "warning: AnalyzerGetSizeOfFreeMemory() is not known here, and on the robot it "
                   "misleads: the heap of an object keeps the memory that free() gives back"));
}

TEST(CheckTest, DesignDataThatIsNotThereIsFound) {
  const KitFolder folder("makefile");
  folder.Write(std::string(kConf) + "DESIGNDB.CFG", "SONG /MS/OPEN-R/MW/DATA/P/SONG.WAV\n");
  EXPECT_THAT(Checked(folder, 0), Says("DESIGNDB.CFG:1:", "FindDesignData(\"SONG\") will fail"));
}

TEST(CheckTest, NetworkSettingsAreRead) {
  const KitFolder folder("makefile");
  folder.Write("MS/OPEN-R/SYSTEM/CONF/WLANCONF.TXT", "ETHER_IP = 10.0.0.1\n");
  EXPECT_THAT(Checked(folder), Says("WLANCONF.TXT:1:", "'='"));
}

TEST(CheckTest, JointsThatNobodyPowersAreNamed) {
  const KitFolder folder("makefile");
  folder.Write("Sender/More.cc", "int format = odataJOINT_COMMAND2;\n");
  const std::string text = Checked(folder, 0);
  EXPECT_THAT(text, Says("Sender:", "no object calls SetMotorPower(opowerON)"));
}

TEST(CheckTest, ABuiltStickIsCheckedByWhatItsImagesSay) {
  const ProgramResult good = RunProgram({"check", std::string(OPENR_BUILD) + "/stick"});
  EXPECT_EQ(good.status, 0) << good.out;
  EXPECT_THAT(good.out, HasSubstr("0 errors, 0 warnings"));
}

TEST(CheckTest, ServicesAreFoundAmongTheTextsOfAnImage) {
  constexpr char kImage[] =
      "\x7f"
      "ELF\0\0A.Text.char.S\0some text.S\0B.In.int.O\0x.y.S\0";
  const std::string image(kImage, sizeof kImage);
  EXPECT_THAT(ServicesInImage(image), ElementsAre("A.Text.char.S", "B.In.int.O"));
}

}  // namespace
}  // namespace openr_host
