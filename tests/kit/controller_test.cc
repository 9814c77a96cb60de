// openr controller: from sources in Webots style to a Memory Stick.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/process.h"
#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr char kMode[] = "PRM:/r1/c1/c2/c3/l7-LED2:l7";

// A folder that `openr controller build` is for.
class ControllerFolder : public KitFolder {
 public:
  ControllerFolder() : KitFolder("") {}

  ProgramResult BuildController(std::vector<std::string> flags = {}) const {
    flags.insert(flags.begin(), {"controller", "build", File("")});
    return RunProgram(flags);
  }
  std::string Checked() const { return RunProgram({"check", File("")}).out; }

  // The report of a run in which the dog has stood up and gone on for some seconds.
  nlohmann::json Run(const std::string& stick = "") const {
    const ProgramResult result =
        RunProgram({"run", "--stick", stick.empty() ? File("") : stick, "--for", "16s", "--rate",
                    "max", "--body", "ideal", "--no-panel", "--rc-port", "0", "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    return nlohmann::json::parse(result.out);
  }
};

int ModeLight(const nlohmann::json& report) { return report["robots"][0]["leds"][kMode]; }

constexpr char kLightsUp[] = R"(
#include <device/led.h>
#include <device/robot.h>
extern void light(void);
static int run(int ms) { light(); return 64; }
int main(void) { robot_run(run); return 0; }
)";
constexpr char kLight[] = R"(
#include <led.h>
#include <robot.h>
void light(void) { led_set(robot_get_device("PRM:/r1/c1/c2/c3/l7-LED2:l7"), 1); }
)";

TEST(ControllerBuildTest, ANewControllerBuildsRunsAndPassesTheCheck) {
  const ControllerFolder folder;
  const ProgramResult made = RunProgram({"controller", "new", "blink", folder.File("")});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(folder.Files(),
            (std::vector<std::string>{"Makefile.openr", "Makefile.sources", "blink.c"}));
  const ProgramResult built = folder.BuildController();
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_EQ(built.err, "");
  EXPECT_THAT(built.out, AllOf(StartsWith("CONTROLL.BIN  program\n"),
                               EndsWith("openr run --stick " + folder.File("") + "\n")));
  EXPECT_EQ(folder.Checked(), "0 errors, 0 warnings, 0 notes\n");
  const nlohmann::json report = folder.Run();
  EXPECT_TRUE(report["findings"].empty()) << report["findings"];
  EXPECT_TRUE(report["robots"][0]["standing"]);
}

TEST(ControllerBuildTest, ANameThatIsNoFileNameIsRefused) {
  const ProgramResult result = RunProgram({"controller", "new", "a b"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("'a b' cannot be the name of a controller"));
}

TEST(ControllerBuildTest, WithoutAListAllSourcesOfTheFolderAreTaken) {
  const ControllerFolder folder;
  folder.Write("main.c", kLightsUp);
  folder.Write("light.c", kLight);
  ASSERT_EQ(folder.BuildController().status, 0);
  EXPECT_EQ(ModeLight(folder.Run()), 1);
}

TEST(ControllerBuildTest, MakefileSourcesNamesTheSourcesWhateverItsVariablesAre) {
  const ControllerFolder folder;
  folder.Write("main.c", kLightsUp);
  folder.Write("lib/light.c", kLight);
  folder.Write("old.c", "this is no C\n");
  folder.Write(
      "Makefile.sources",
      "# what is compiled; not old.c\nC_SOURCES = main.c \\\n  lib/light.c\nCPP_SOURCES =\n");
  const ProgramResult built = folder.BuildController();
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_EQ(ModeLight(folder.Run()), 1);
}

TEST(ControllerBuildTest, CAndCxxSourcesMakeOneController) {
  const ControllerFolder folder;
  folder.Write("main.cpp", std::string("extern \"C\" void light(void);\n") +
                               "#include <device/robot.h>\n"
                               "struct Lamp { Lamp() : times(0) {} int times; };\n"
                               "static Lamp lamp;\n"
                               "static int run(int) { lamp.times++; light(); return 32; }\n"
                               "int main(int argc, char** argv) {\n"
                               "  robot_run(argc == 1 && argv[1] == 0 ? run : 0);\n"
                               "}\n");
  folder.Write("light.c", kLight);
  const ProgramResult built = folder.BuildController();
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_EQ(ModeLight(folder.Run()), 1);
}

// Each is another symbol, and the call is generated for the one that is there.
TEST(ControllerBuildTest, EveryWayToWriteMainIsCalled) {
  struct Form {
    const char* file;
    const char* main;
  };
  const Form forms[] = {{"a.c", "int main(void)"},
                        {"a.c", "int main(int argc, char** argv)"},
                        {"a.cc", "int main()"},
                        {"a.cc", "int main(int argc, char** argv)"},
                        {"a.cc", "int main(int argc, const char** argv)"},
                        {"a.cc", "extern \"C\" int main()"}};
  for (const Form& form : forms) {
    SCOPED_TRACE(std::string(form.file) + ": " + form.main);
    const bool has_arguments = std::string(form.main).find("argc") != std::string::npos;
    const ControllerFolder folder;
    folder.Write(
        form.file,
        std::string("#include <device/led.h>\n#include <device/robot.h>\n"
                    "static int run(int ms) {\n"
                    "  led_set(robot_get_device(\"PRM:/r1/c1/c2/c3/l7-LED2:l7\"), 1);\n"
                    "  return ms + 64;\n}\n") +
            form.main + " {\n" +
            (has_arguments ? "  if (argc != 1 || argv[0] == 0 || argv[1] != 0) return 1;\n" : "") +
            "  robot_run(run);\n  return 0;\n}\n");
    const ProgramResult built = folder.BuildController();
    ASSERT_EQ(built.status, 0) << built.err;
    EXPECT_EQ(ModeLight(folder.Run()), 1);
  }
}

TEST(ControllerBuildTest, ThePartThatControllersAreLinkedWithHasNoWeakSymbolLeftUndefined) {
  const ProcessResult listed =
      RunProcess({"nm", "-P", OPENR_BUILD "/share/openr-host/sdk/controller/controller.o"},
                 {{}, "", true, true, true});
  ASSERT_TRUE(listed.good()) << listed.output;
  EXPECT_THAT(listed.output, HasSubstr("CallControllerMain"));
  std::istringstream lines(listed.output);
  for (std::string line, name, letter; std::getline(lines, line);) {
    std::istringstream(line) >> name >> letter;
    EXPECT_TRUE(letter != "w" && letter != "v") << line;
  }
}

TEST(ControllerBuildTest, AFileTheListNamesInVainIsSaidWithItsPlace) {
  const ControllerFolder folder;
  folder.Write("Makefile.sources", "SOURCES = wave.c\n");
  const ProgramResult built = folder.BuildController();
  EXPECT_EQ(built.status, 1);
  EXPECT_EQ(built.err, folder.File("Makefile.sources") +
                           ":1: there is no file 'wave.c'\nSOURCES = wave.c\n          ^\n");
}

TEST(ControllerBuildTest, TheListIsReadAsMakeReadsIt) {
  const ControllerFolder folder;
  folder.Write("src/main.c", kLightsUp);
  folder.Write("lib/light.c", kLight);
  folder.Write("old.c", "this is no C\n");
  folder.Write("Makefile.sources",
               "LIB = lib\nSOURCES = $(wildcard src/*.c) $(addprefix $(LIB)/,light.c)\n");
  const ProgramResult built = folder.BuildController();
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_EQ(ModeLight(folder.Run()), 1);
}

TEST(ControllerBuildTest, AListThatNamesNoSourceIsAMistake) {
  const ControllerFolder folder;
  folder.Write("Makefile.sources", "OBJS = blink.o\n");
  const ProgramResult built = folder.BuildController();
  EXPECT_EQ(built.status, 1);
  EXPECT_THAT(built.err, HasSubstr("Makefile.sources:1: names no source (*.c, *.cc, *.cpp)"));
}

TEST(ControllerBuildTest, AMainThatNobodyWouldCallIsRefused) {
  const ControllerFolder folder;
  folder.Write("main.cc", "int main(int, char**, char**) { return 0; }\n");
  EXPECT_THAT(folder.BuildController().err,
              HasSubstr("main() has arguments, and the robot gives none"));
  folder.Write("main.cc", "int helper() { return 0; }\n");
  EXPECT_THAT(folder.BuildController().err, HasSubstr("no source has a main()"));
  folder.Write("main.cc", "int main() { return 0; }\n");
  folder.Write("other.c", "int main(void) { return 0; }\n");
  EXPECT_THAT(folder.BuildController().err, HasSubstr("main() is in more than one source"));
}

TEST(ControllerBuildTest, MotionsTravelAlongUnderTheRobotsNames) {
  const ControllerFolder folder;
  folder.Write("main.c", kLightsUp);
  folder.Write("light.c", kLight);
  folder.Write("nod.mtn", "no motion, but that is not looked at here");
  ASSERT_EQ(folder.BuildController().status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.File("OPEN-R/MW/DATA/P/NOD.MTN")));
  folder.Write("toolongname.mtn", "");
  const ProgramResult refused = folder.BuildController();
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("toolongname.mtn"));
}

TEST(ControllerBuildTest, AListWithoutSourcesMakesTheEmptyController) {
  const ControllerFolder folder;
  folder.Write("Makefile.sources", "SOURCES =\n");
  const ProgramResult built = folder.BuildController();
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_THAT(built.out, HasSubstr("empty: Makefile.sources names no source"));
  const nlohmann::json report = folder.Run();
  EXPECT_TRUE(report["findings"].empty());
  for (const auto& [name, light] : report["robots"][0]["leds"].items()) EXPECT_EQ(light, 0) << name;
}

TEST(ControllerBuildTest, AFolderWithoutSourcesIsRefused) {
  const ControllerFolder folder;
  const ProgramResult built = folder.BuildController();
  EXPECT_EQ(built.status, 1);
  EXPECT_THAT(built.err, HasSubstr("no *.c, *.cc or *.cpp and no Makefile.sources in it"));
}

TEST(ControllerBuildTest, WhatDoesNotCompileChangesNothing) {
  const ControllerFolder folder;
  folder.Write("wave.c", "int main(void) { return wave; }\n");
  const ProgramResult built = folder.BuildController();
  EXPECT_EQ(built.status, 1);
  EXPECT_THAT(built.err, HasSubstr("wave.c:1:"));
  EXPECT_EQ(folder.Files(), std::vector<std::string>{"wave.c"});
}

TEST(ControllerBuildTest, AFunctionThatTheControllerObjectLacksIsNamed) {
  const ControllerFolder folder;
  folder.Write("wheels.c",
               "void differential_wheels_set_speed(int, int);\n"
               "int main(void) { differential_wheels_set_speed(10, 10); return 0; }\n");
  const ProgramResult built = folder.BuildController();
  EXPECT_EQ(built.status, 1);
  EXPECT_THAT(built.err, HasSubstr("differential_wheels_set_speed"));
}

TEST(ControllerBuildTest, NetworkAndMotionsTravelWithTheController) {
  const ControllerFolder folder;
  folder.Write("main.c", kLightsUp);
  folder.Write("light.c", kLight);
  folder.Write("WLANCONF.TXT", "HOSTNAME=mine\n");
  folder.Write("NOD.MTN", "OMTN");
  const std::string stick = folder.scratch().File("stick");
  const ProgramResult built = folder.BuildController({"-o", stick});
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_FALSE(std::filesystem::exists(folder.File("OPEN-R")));
  EXPECT_EQ(folder.scratch().Read("stick/OPEN-R/SYSTEM/CONF/WLANCONF.TXT"), "HOSTNAME=mine\n");
  EXPECT_EQ(folder.scratch().Read("stick/OPEN-R/MW/DATA/P/NOD.MTN"), "OMTN");
  EXPECT_EQ(ModeLight(folder.Run(stick)), 1);
}

TEST(ControllerBuildTest, AllFilesThatNoStickCanHaveAreNamed) {
  const ControllerFolder folder;
  folder.Write("main.c", kLightsUp);
  folder.Write("light.c", kLight);
  folder.Write("WLANCONF.TXT", "HOSTNAME=mine\n");
  const std::vector<std::string> motions = {"a-nod.for-a-yes.mtn", "bow-to-the-left.mtn",
                                            "circle-around.mtn", "dance-on-3-legs.mtn"};
  for (const std::string& motion : motions) folder.Write(motion, "OMTN");
  const ProgramResult built = folder.BuildController();
  EXPECT_EQ(built.status, 1);
  for (const std::string& motion : motions) EXPECT_THAT(built.err, HasSubstr(motion));
}

TEST(ControllerBuildTest, OnAStickThatIsThereOnlyTheControllerIsReplaced) {
  const ControllerFolder folder;
  folder.Write("main.c", kLightsUp);
  folder.Write("light.c", kLight);
  ASSERT_EQ(folder.BuildController().status, 0);
  folder.Write("OPEN-R/SYSTEM/CONF/WLANCONF.TXT", "HOSTNAME=mine\n");
  folder.Write("light.c", "void light(void) {}\n");
  ASSERT_EQ(folder.BuildController().status, 0);
  EXPECT_EQ(folder.Read("OPEN-R/SYSTEM/CONF/WLANCONF.TXT"), "HOSTNAME=mine\n");
  EXPECT_EQ(ModeLight(folder.Run()), 0);
}

TEST(ControllerBuildTest, MakefileOpenrBuildsAndCleans) {
  const ControllerFolder folder;
  ASSERT_EQ(RunProgram({"controller", "new", "blink", folder.File("")}).status, 0);
  const std::string make =
      "make -s -C " + folder.File("") + " -f Makefile.openr OPENR=" + OPENR_PROGRAM;
  EXPECT_EQ(std::system((make + " > /dev/null").c_str()), 0);
  EXPECT_TRUE(std::filesystem::exists(folder.File("OPEN-R/MW/OBJS/CONTROLL.BIN")));
  EXPECT_EQ(std::system((make + " clean").c_str()), 0);
  EXPECT_EQ(folder.Files(),
            (std::vector<std::string>{"Makefile.openr", "Makefile.sources", "blink.c"}));
}

TEST(ControllerBuildTest, TheRobotNeedsTheSdk) {
  const ControllerFolder folder;
  folder.Write("main.c", kLightsUp);
  unsetenv("OPENRSDK_ROOT");
  const ProgramResult built = folder.BuildController({"--robot", "-o", folder.File("dog")});
  EXPECT_EQ(built.status, 1);
  EXPECT_THAT(built.err, HasSubstr("OPENRSDK_ROOT is not set"));
}

TEST(ControllerBuildTest, BuildSaysWhatAControllerIsBuiltWith) {
  const ControllerFolder folder;
  folder.Write("main.c", kLightsUp);
  const ProgramResult built = folder.Build();
  EXPECT_EQ(built.status, 1);
  EXPECT_THAT(built.err, HasSubstr("a controller, not an OPEN-R object; openr controller build " +
                                   folder.File("")));
}

// Builds copies of the examples, so that no built file gets into the sources.
TEST(ControllerBuildTest, EveryExampleBuildsAndPassesTheCheck) {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(OPENR_EXAMPLE_CONTROLLERS)) {
    if (!entry.is_directory()) continue;
    const ControllerFolder folder;
    fs::copy(entry.path(), folder.File(""), fs::copy_options::recursive);
    names.push_back(entry.path().filename());
    SCOPED_TRACE(names.back());
    const ProgramResult built = folder.BuildController();
    EXPECT_EQ(built.status, 0);
    EXPECT_EQ(built.err, "");
    EXPECT_EQ(folder.Checked(), "0 errors, 0 warnings, 0 notes\n");
    EXPECT_TRUE(folder.Run()["findings"].empty());
    EXPECT_TRUE(fs::exists(folder.File("Makefile.openr")));
  }
  EXPECT_GE(names.size(), 10u);
}

// ---- What happens to it in a run -------------------------------------------------------

TEST(ControllerRunTest, AnUnknownDeviceIsAFindingThatNamesTheNearestOne) {
  const ControllerFolder folder;
  folder.Write("main.c", R"(
#include <device/robot.h>
static int run(int ms) { robot_get_device("PRM:/r1/c1/c2/c3/l7-LED2:l8"); return 64; }
int main(void) { robot_get_device("wheel"); robot_run(run); return 0; }
)");
  ASSERT_EQ(folder.BuildController().status, 0);
  const nlohmann::json findings = folder.Run()["findings"];
  ASSERT_EQ(findings.size(), 2u) << findings;
  EXPECT_EQ(findings[0]["text"],
            "robot_get_device: there is no device 'wheel'; what it is told goes nowhere, and it "
            "reads 0");
  EXPECT_EQ(findings[1]["text"],
            "robot_get_device: there is no device 'PRM:/r1/c1/c2/c3/l7-LED2:l8'; what it is told "
            "goes nowhere, and it reads 0; did you mean 'PRM:/r1/c1/c2/c3/l7-LED2:l7'?");
  EXPECT_EQ(findings[1]["count"], 1);
  EXPECT_EQ(findings[1]["object"], "Controller");
}

#if !defined(__SANITIZE_ADDRESS__)  // AddressSanitizer reports such faults itself
TEST(ControllerRunTest, ANaNInAnEndlessLoopIsFoundWithItsLine) {
  const ControllerFolder folder;
  folder.Write("main.c", R"(#include <device/robot.h>
int main(void)
{
    volatile float zero = 0, number = 0;
    for (;;) {
        number = zero / zero;
        robot_step(64);
    }
}
)");
  ASSERT_EQ(folder.BuildController().status, 0);
  const std::string findings = folder.Run()["findings"].dump();
  EXPECT_THAT(findings, HasSubstr("at main.c:6: a floating-point operation made NaN"));
}

// main() has a stack of its own here, the run function that of handlers.
TEST(ControllerRunTest, AStackOverflowIsCalledByItsNameOnEitherStack) {
  for (const char* const main : {"return deep(0);", "robot_run(deep); return 0;"}) {
    const ControllerFolder folder;
    folder.Write("main.c", std::string("#include <device/robot.h>\n"
                                       "static volatile int sink;\n"
                                       "static int deep(int depth)\n"
                                       "{\n"
                                       "    volatile char room[1000];\n"
                                       "    room[0] = (char)depth;\n"
                                       "    sink = room[0];\n"
                                       "    return depth < 0 ? 0 : deep(depth + 1) + room[0];\n"
                                       "}\n"
                                       "int main(void) { ") +
                               main + " }\n");
    ASSERT_EQ(folder.BuildController().status, 0);
    const ProgramResult result =
        RunProgram({"run", "--stick", folder.File(""), "--for", "16s", "--rate", "max", "--body",
                    "ideal", "--no-panel", "--rc-port", "0", "--json"});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.err, HasSubstr("OBJECT Controller, Controller.MainExecution."));
    EXPECT_THAT(result.err, HasSubstr("STACK overflow: the handler used more than 256 KiB"));
    const nlohmann::json findings = nlohmann::json::parse(result.out)["findings"];
    ASSERT_EQ(findings.size(), 1u) << findings;
    EXPECT_EQ(findings[0]["object"], "Controller");
    EXPECT_THAT(findings[0]["text"].get<std::string>(), HasSubstr(", a stack overflow: more than"));
  }
}
#endif

}  // namespace
}  // namespace openr_host
