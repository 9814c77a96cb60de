// openr check before the first build: programs laid out as they were at the time have no mistakes,
// and it says no more than afterwards.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string Replaced(std::string text, const std::string& mark, const std::string& value) {
  for (size_t at = text.find(mark); at != std::string::npos;
       at = text.find(mark, at + value.size()))
    text.replace(at, mark.size(), value);
  return text;
}

// An object that sends what it hears.
constexpr char kStub[] =
    "ObjectName : @\nNumOfOSubject : 1\nNumOfOObserver : 1\n"
    "Service : \"@.Out.char.S\", null, Ready()\nService : \"@.In.char.O\", null, Notify()\n";
constexpr char kHeader[] =
    "#include <OPENR/OObject.h>\n#include <OPENR/OSubject.h>\n#include <OPENR/OObserver.h>\n"
    "#include \"def.h\"\nclass @ : public OObject {\npublic:\n"
    "    OSubject* subject[numOfSubject];\n    OObserver* observer[numOfObserver];\n"
    "    virtual OStatus DoInit(const OSystemEvent& event);\n"
    "    virtual OStatus DoStart(const OSystemEvent& event);\n"
    "    virtual OStatus DoStop(const OSystemEvent& event);\n"
    "    virtual OStatus DoDestroy(const OSystemEvent& event);\n"
    "    void Ready(const OReadyEvent& event);\n    void Notify(const ONotifyEvent& event);\n};\n";
constexpr char kLife[] =
    "#include <OPENR/core_macro.h>\n#include \"@.h\"\n"
    "OStatus @::DoInit(const OSystemEvent&)\n{\n    NEW_ALL_SUBJECT_AND_OBSERVER;\n"
    "    REGISTER_ALL_ENTRY;\n    SET_ALL_READY_AND_NOTIFY_ENTRY;\n    return oSUCCESS;\n}\n"
    "OStatus @::DoStart(const OSystemEvent&)\n{\n    ENABLE_ALL_SUBJECT;\n"
    "    ASSERT_READY_TO_ALL_OBSERVER;\n    return oSUCCESS;\n}\n"
    "OStatus @::DoStop(const OSystemEvent&)\n{\n    DISABLE_ALL_SUBJECT;\n"
    "    DEASSERT_READY_TO_ALL_OBSERVER;\n    return oSUCCESS;\n}\n"
    "OStatus @::DoDestroy(const OSystemEvent&)\n{\n    DELETE_ALL_SUBJECT_AND_OBSERVER;\n"
    "    return oSUCCESS;\n}\n";
constexpr char kHandlers[] =
    "#include \"@.h\"\nvoid @::Ready(const OReadyEvent&) {}\n"
    "void @::Notify(const ONotifyEvent& event)\n{\n    "
    "observer[event.ObsIndex()]->AssertReady();\n}\n";
constexpr char kOcf[] = "object # 3072 16384 128 cache tlb user\n";

// Variables and rules of an object's Makefile; `more` comes first.
std::string MakefileOf(const std::string& name, const std::string& object, const std::string& image,
                       const std::string& more) {
  constexpr char kRules[] =
      "PREFIX=/usr/local/OPEN_R_SDK\n"
      "CXX=$(PREFIX)/bin/mipsel-linux-g++\n"
      "MKBIN=$(PREFIX)/OPEN_R/bin/mkbin\n"
      "STUBGEN=$(PREFIX)/OPEN_R/bin/stubgen2\n"
      "STUB?=stub.cfg\n"
      "INSTALLDIR?=../MS\n"
      "CXXFLAGS=-O2 -I. $(INC) -I$(PREFIX)/OPEN_R/include/R4000 -I$(PREFIX)/OPEN_R/include\n"
      "all: #.bin\n"
      "%.o: %.cc\n\t$(CXX) $(CXXFLAGS) -o $@ -c $<\n"
      "@Stub.cc def.h: $(STUB)\n\t$(STUBGEN) $(STUB)\n"
      "@.o Handlers.o: def.h\n"
      "#.bin: @Stub.o @.o Handlers.o #.ocf\n"
      "\t$(MKBIN) -p $(PREFIX) -o $@ $^ -lObjectComm -lOPENR\n"
      "install: #.bin\n\tgzip -c #.bin > $(INSTALLDIR)/OPEN-R/MW/OBJS/IMAGE\n";
  std::string rules = kRules;
  rules = Replaced(Replaced(rules, "#.", object + "."), "IMAGE", image);
  // "$@" is make's own.
  rules = Replaced(Replaced(rules, "@Stub", name + "Stub"), "@.o", name + ".o");
  return more + rules;
}

class CheckBeforeBuildTest : public ::testing::Test {
 protected:
  // The four texts of an object, wherever each lies; folders end in a slash.
  void WriteObject(const std::string& name, const std::string& object, const std::string& stub,
                   const std::string& headers, const std::string& sources,
                   const std::string& ocf) const {
    folder.Write(stub + "stub.cfg", Replaced(kStub, "@", name));
    folder.Write(headers + name + ".h", Replaced(kHeader, "@", name));
    folder.Write(sources + name + ".cc", Replaced(kLife, "@", name));
    folder.Write(sources + "Handlers.cc", Replaced(kHandlers, "@", name));
    folder.Write(ocf + object + ".ocf", Replaced(kOcf, "#", object));
  }

  void WriteStick(const std::string& root, const std::string& objects,
                  const std::string& connections) const {
    folder.Write(root + "/OPEN-R/MW/CONF/OBJECT.CFG", objects);
    folder.Write(root + "/OPEN-R/MW/CONF/CONNECT.CFG", connections);
  }

  // Errors and warnings of `openr check`, in a line.
  std::string Count(const std::string& below = "") const {
    const ProgramResult result = RunProgram({"check", "--json", folder.File(below)});
    const auto json = nlohmann::json::parse(result.out, nullptr, false);
    if (json.is_discarded()) return result.err;
    std::string said = std::to_string(json["errors"].get<int>()) + " errors, " +
                       std::to_string(json["warnings"].get<int>()) + " warnings";
    for (const auto& remark : json["remarks"]) {
      if (remark["severity"] == "note") continue;
      said += "\n" + remark["file"].get<std::string>() + ":" +
              std::to_string(remark["line"].get<int>()) + ": " + remark["text"].get<std::string>();
    }
    return said;
  }

  void ExpectGoodBeforeAndAfterABuild(const std::string& below = "") const {
    EXPECT_EQ(Count(below), "0 errors, 0 warnings") << "before the build";
    const ProgramResult built = RunProgram({"build", folder.File(below)});
    EXPECT_EQ(built.status, 0) << built.out << built.err;
    EXPECT_EQ(Count(below), "0 errors, 0 warnings") << "after the build";
  }

  const KitFolder folder{""};
};

constexpr char kPing[] = "/MS/OPEN-R/MW/OBJS/PING.BIN\n";
constexpr char kPingToItself[] = "Ping.Out.char.S Ping.In.char.O\n";

TEST_F(CheckBeforeBuildTest, SourcesInTheFolderAboveOfTheMakefile) {
  WriteObject("Ping", "ping", "Ping/robot/", "Ping/", "Ping/", "Ping/robot/");
  folder.Write(
      "Ping/robot/Makefile",
      MakefileOf("Ping", "ping", "PING.BIN", "VPATH = ..\nINC = -I..\nINSTALLDIR = ../../MS\n"));
  WriteStick("MS", kPing, kPingToItself);
  ExpectGoodBeforeAndAfterABuild();
}

// The person checks a folder that only has a Makefile and a stick.
TEST_F(CheckBeforeBuildTest, ObjectsInAFolderBesideWhoseMakefileLooksAbove) {
  WriteObject("Ping", "ping", "Ping/robot/", "Ping/", "Ping/", "Ping/robot/");
  folder.Write("Ping/robot/Makefile",
               MakefileOf("Ping", "ping", "PING.BIN", "VPATH=..\nINC=-I..\n"));
  folder.Write("variants/one/Makefile",
               "all install:\n\tcd ../../Ping/robot && "
               "$(MAKE) INSTALLDIR=../../variants/one/MS $@\n");
  WriteStick("variants/one/MS", kPing, kPingToItself);
  ExpectGoodBeforeAndAfterABuild("variants/one");
}

TEST_F(CheckBeforeBuildTest, StubConfigInASiblingFolder) {
  WriteObject("Ping", "ping", "stubs/PingStubs/", "src/", "src/", "src/");
  folder.Write("src/Makefile",
               MakefileOf("Ping", "ping", "PING.BIN", "STUB = ../stubs/PingStubs/stub.cfg\n"));
  WriteStick("MS", kPing, kPingToItself);
  ExpectGoodBeforeAndAfterABuild();
}

TEST_F(CheckBeforeBuildTest, HeadersAndHandlersInCommonFolders) {
  WriteObject("Ping", "ping", "Ping/", "include/", "Ping/", "Ping/");
  // The handlers are those of a base class that two objects could have.
  folder.Write("include/Ping.h",
               Replaced(Replaced(kHeader, "public OObject", "public Base"), "@", "Ping") +
                   std::string("\n"));
  std::string header = folder.Read("include/Ping.h");
  header.insert(0, "#include \"../common/Base.h\"\n");
  header = Replaced(header, "    void Ready(const OReadyEvent& event);\n", "");
  folder.Write("include/Ping.h", header);
  folder.Write("common/Base.h",
               "#ifndef BASE_H\n#define BASE_H\n#include <OPENR/OObject.h>\n"
               "class Base : public OObject {\npublic:\n"
               "    void Ready(const OReadyEvent& event);\n};\n#endif\n");
  folder.Write("common/Base.cc", "#include \"Base.h\"\nvoid Base::Ready(const OReadyEvent&) {}\n");
  folder.Write("Ping/Handlers.cc",
               "#include \"Ping.h\"\nvoid Ping::Notify(const ONotifyEvent& event)\n{\n"
               "    observer[event.ObsIndex()]->AssertReady();\n}\n");
  folder.Write("Ping/Makefile",
               Replaced(MakefileOf("Ping", "ping", "PING.BIN",
                                   "VPATH = ../common\nINC = -I../include -I../common\n"),
                        "Ping.o Handlers.o ping", "Ping.o Handlers.o Base.o ping"));
  WriteStick("MS", kPing, kPingToItself);
  ExpectGoodBeforeAndAfterABuild();
}

// The folder of one object, whose Makefile includes rules and takes sources from far away.
TEST_F(CheckBeforeBuildTest, PathsBehindVariablesAndInIncludedMakefiles) {
  WriteObject("Ping", "ping", "src/Ping/", "lib/inc/", "src/Ping/", "src/Ping/");
  std::filesystem::create_directories(folder.File("lib/handlers"));
  std::filesystem::rename(folder.File("src/Ping/Handlers.cc"),
                          folder.File("lib/handlers/Handlers.cc"));
  folder.Write("rules.mk", "LIB = $(TOP)/lib\nVPATH = $(LIB)/handlers\nINC = -I$(LIB)/inc\n");
  folder.Write("src/Ping/Makefile",
               MakefileOf("Ping", "ping", "PING.BIN",
                          "TOP = ../..\ninclude $(TOP)/rules.mk\nINSTALLDIR = MS\n"));
  WriteStick("src/Ping/MS", kPing, kPingToItself);
  ExpectGoodBeforeAndAfterABuild("src/Ping");
}

// Nothing in the names says which is which, and two sticks hold one object each.
TEST_F(CheckBeforeBuildTest, ImagesNamedOtherwiseThanTheirFoldersOnSeveralSticks) {
  WriteObject("Ping", "ping", "first/", "first/", "first/", "first/");
  WriteObject("Pong", "pong", "second/", "second/", "second/", "second/");
  folder.Write("first/Makefile", MakefileOf("Ping", "ping", "$(IMAGE)",
                                            "IMAGE = QX.BIN\nINSTALLDIR = ../robot/stick1\n"));
  folder.Write("second/Makefile", MakefileOf("Pong", "pong", "$(TARGET)",
                                             "TARGET = ZY2.BIN\nINSTALLDIR = ../robot/stick2\n"));
  folder.Write("Makefile",
               "all install:\n\tfor d in first second; do (cd $$d && $(MAKE) $@); done\n");
  WriteStick("robot/stick1", "/MS/OPEN-R/MW/OBJS/QX.BIN\n", kPingToItself);
  WriteStick("robot/stick2", "/MS/OPEN-R/MW/OBJS/ZY2.BIN\n", "Pong.Out.char.S Pong.In.char.O\n");
  ExpectGoodBeforeAndAfterABuild();
}

// Two objects have one name, and each robot loads one of them.
TEST_F(CheckBeforeBuildTest, SectionsOfRobotsExcludeEachOther) {
  WriteObject("Ping", "ball", "Ping/", "Ping/", "Ping/", "Ping/");
  WriteObject("Ping7", "ball", "Ping7/", "Ping7/", "Ping7/", "Ping7/");
  folder.Write("Ping/Makefile", MakefileOf("Ping", "ball", "PING.BIN", ""));
  folder.Write("Ping7/Makefile", MakefileOf("Ping7", "ball", "PING7.BIN", ""));
  folder.Write("Makefile",
               "all install:\n\tfor d in Ping Ping7; do (cd $$d && $(MAKE) $@); done\n");
  WriteStick("MS",
             "[ERS-210]\n/MS/OPEN-R/MW/OBJS/PING.BIN\n[ERS-7]\n/MS/OPEN-R/MW/OBJS/PING7.BIN\n",
             "[ERS-210]\nPing.Out.char.S Ping.In.char.O\n"
             "[ERS-7]\nPing7.Out.char.S Ping7.In.char.O\n");
  folder.Write(
      "MS/OPEN-R/MW/CONF/DESIGNDB.CFG",
      "[ERS-210]\nSONG /MS/OPEN-R/MW/DATA/P/A.WAV\n[ERS-7]\nSONG /MS/OPEN-R/MW/DATA/P/B.WAV\n");
  folder.Write("MS/OPEN-R/MW/DATA/P/A.WAV", "");
  folder.Write("MS/OPEN-R/MW/DATA/P/B.WAV", "");
  ExpectGoodBeforeAndAfterABuild();

  // Where both hold, the name is taken twice.
  WriteStick("MS", "/MS/OPEN-R/MW/OBJS/PING.BIN\n[ERS-7]\n/MS/OPEN-R/MW/OBJS/PING7.BIN\n", "");
  EXPECT_THAT(Count(), HasSubstr("names in .ocf files must differ"));
}

TEST_F(CheckBeforeBuildTest, ALineForARobotThatDoesNotLoadTheObject) {
  WriteObject("Ping", "ping", "Ping/", "Ping/", "Ping/", "Ping/");
  WriteStick(
      "MS", "[ERS-210]\n/MS/OPEN-R/MW/OBJS/PING.BIN\n",
      "[ERS-210]\nPing.Out.char.S Ping.In.char.O\n[ERS-7]\nPing.Out.char.S Ping.In.char.O\n");
  EXPECT_THAT(Count(),
              HasSubstr("CONNECT.CFG:4: OBJECT.CFG loads Ping for [ERS-210] only, and this "
                        "line holds for [ERS-7]: 'Ping.Out.char.S' is NOT FOUND there"));
  EXPECT_THAT(Count(), HasSubstr("0 errors, 2 warnings"));
}

// Binaries for the dog lie where a build will put those for the host.
TEST_F(CheckBeforeBuildTest, BinariesForTheRobotAreReplacedWhereTheirSourcesAre) {
  WriteObject("Ping", "ping", "Ping/", "Ping/", "Ping/", "Ping/");
  std::string mips(64, '\0');
  mips.replace(0, 6,
               "\x7f"
               "ELF\1\1");
  mips[18] = 8;  // EM_MIPS
  WriteStick("MS", kPing, kPingToItself);
  folder.Write("MS/OPEN-R/MW/OBJS/PING.BIN", mips);
  ExpectGoodBeforeAndAfterABuild();
  // A stick alone has nothing that could replace it.
  folder.Write("MS/OPEN-R/MW/OBJS/PING.BIN", mips);
  EXPECT_THAT(Count("MS"), HasSubstr("PING.BIN is a binary for the robot (MIPS)"));
}

// The same layouts with a mistake in each.
TEST_F(CheckBeforeBuildTest, MistakesAreStillFoundInOtherFolders) {
  WriteObject("Ping", "ping", "Ping/robot/", "Ping/", "Ping/", "Ping/robot/");
  folder.Write(
      "Ping/robot/Makefile",
      MakefileOf("Ping", "ping", "PING.BIN", "VPATH = ..\nINC = -I..\nINSTALLDIR = ../../MS\n"));
  WriteStick("MS", std::string(kPing) + "/MS/OPEN-R/MW/OBJS/PINGG.BIN\n",
             std::string(kPingToItself) + "Pong.Out.char.S Pong.In.char.O\n");
  folder.Write("Ping/Handlers.cc", "#include \"Ping.h\"\n");
  folder.Write("Ping/Ping.h", Replaced(Replaced(kHeader, "@", "Ping"), "void Ready", "void Redy"));
  folder.Write("Ping/Ping.cc",
               Replaced(Replaced(Replaced(kLife, "@", "Ping"), "    REGISTER_ALL_ENTRY;\n", ""),
                        "ASSERT_READY_TO_ALL_OBSERVER", "NOTHING"));
  // Another object's words are not its own.
  WriteObject("Pong", "pong", "Pong/", "Pong/", "Pong/", "Pong/");
  std::filesystem::remove(folder.File("Pong/Pong.h"));
  const std::string said = Count();
  EXPECT_THAT(said, HasSubstr("Ping/robot/stub.cfg:4: no Ready() in the sources of robot"));
  EXPECT_THAT(said, HasSubstr("Ping/robot/stub.cfg:4: no REGISTER_ALL_ENTRY in DoInit"));
  EXPECT_THAT(said, HasSubstr("AssertReady is never called: Notify() will not be either"));
  EXPECT_THAT(said, HasSubstr("Pong/stub.cfg:1: the stub includes \"Pong.h\""));
}

TEST_F(CheckBeforeBuildTest, AMisspeltImageIsFoundAmongThoseThatMakefilesInstall) {
  WriteObject("Ping", "ping", "Ping/", "Ping/", "Ping/", "Ping/");
  folder.Write("Ping/Makefile", MakefileOf("Ping", "ping", "$(NAME)", "NAME = PPING.BIN\n"));
  WriteObject("Pong", "pong", "Pong/", "Pong/", "Pong/", "Pong/");
  WriteStick("MS",
             "/MS/OPEN-R/MW/OBJS/PPING.BIN\n/MS/OPEN-R/MW/OBJS/PONG.BIN\n"
             "/MS/OPEN-R/MW/OBJS/PIING.BIN\n",
             "");
  EXPECT_THAT(Count(),
              HasSubstr("OBJECT.CFG:3: /MS/OPEN-R/MW/OBJS/PIING.BIN does not exist on the "
                        "stick; the robot stops with error 90; did you mean 'PPING.BIN'?"));
}

TEST_F(CheckBeforeBuildTest, AMissingConnectConfigMeansNoConnections) {
  WriteObject("Ping", "ping", "Ping/", "Ping/", "Ping/", "Ping/");
  folder.Write("MS/OPEN-R/MW/CONF/OBJECT.CFG", kPing);
  ExpectGoodBeforeAndAfterABuild();
  const ProgramResult result = RunProgram({"check", folder.File("")});
  EXPECT_THAT(result.out, HasSubstr("CONNECT.CFG: note: is missing: no object is connected\n"));
}

TEST_F(CheckBeforeBuildTest, NetworkSettingsInAWrongPlaceAreNamed) {
  WriteObject("Ping", "ping", "Ping/", "Ping/", "Ping/", "Ping/");
  WriteStick("MS", kPing, kPingToItself);
  folder.Write("MS/OPEN-R/SYSTEM/CONF/WLANDFLT.TXT", "");
  EXPECT_EQ(Count(), "0 errors, 0 warnings");
  for (const char* place : {"MS/WLANCONF.TXT", "MS/OPEN-R/MW/CONF/WLANCONF.TXT"}) {
    folder.Write(place, "HOSTNAME=AIBO\n");
    EXPECT_THAT(Count(), HasSubstr(std::string(place) + ":0: lies in the wrong folder"));
    std::filesystem::remove(folder.File(place));
  }
  folder.Write("MS/OPEN-R/SYSTEM/CONF/WLANCNF.TXT", "HOSTNAME=AIBO\n");
  EXPECT_THAT(Count(), HasSubstr("did you mean WLANCONF.TXT?"));
}

// Nobody brought the object Legs, and forty lines speak of it.
TEST_F(CheckBeforeBuildTest, EqualConsequencesOfOneMissingThingAreOneRemark) {
  WriteObject("Ping", "ping", "Ping/", "Ping/", "Ping/", "Ping/");
  std::string lines;
  for (int i = 0; i < 40; ++i) lines += "Ping.Out.char.S Legs.In" + std::to_string(i) + ".char.O\n";
  WriteStick("MS", kPing, lines + "Ping.Owt.char.S Ping.In.char.O\n");
  EXPECT_THAT(Count(), HasSubstr("2 errors, 0 warnings\n"));
  const ProgramResult result = RunProgram({"check", folder.File("")});
  EXPECT_THAT(result.out, HasSubstr("no object on this stick has 'Legs.In0.char.O'"));
  EXPECT_THAT(result.out, HasSubstr("  also at CONNECT.CFG:2, CONNECT.CFG:3, CONNECT.CFG:4, "
                                    "CONNECT.CFG:5, CONNECT.CFG:6 and 34 more\n"));
  EXPECT_THAT(result.out, Not(HasSubstr("Legs.In1.")));
  EXPECT_THAT(result.out,
              HasSubstr("CONNECT.CFG:41: no object on this stick has 'Ping.Owt.char.S'"));
}

}  // namespace
}  // namespace openr_host
