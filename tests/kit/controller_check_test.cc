// openr check of a controller: what would not work on the robot.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kit/check.h"
#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

const std::vector<std::string> kLocators = {"PRM:/r1/c1-Joint2:j1", "PRM:/r1/l7-LED2:l7",
                                            "PRM:/r1/l6-LED2:l6"};

class ControllerCheckTest : public ::testing::Test {
 protected:
  std::vector<Remark> Remarked() const { return CheckFolder(folder.File(""), kLocators).all(); }
  // Returns the remarks about a controller whose only source is `source`.
  std::vector<Remark> Remarked(const std::string& source) const {
    folder.Write("wave.c", source);
    return Remarked();
  }
  std::string Checked(const std::string& source) const {
    folder.Write("wave.c", source);
    return RenderRemarks(CheckFolder(folder.File(""), kLocators));
  }
  // The remarks about a controller whose run function has this body.
  std::vector<Remark> InRun(const std::string& body) const {
    return Remarked("#include <device/robot.h>\nstatic int run(int ms)\n{\n" + body +
                    "\nreturn 64;\n}\nint main(void) { robot_run(run); return 0; }\n");
  }

  const KitFolder folder{""};
};

::testing::Matcher<const Remark&> Error(int line, const std::string& text) {
  return AllOf(::testing::Field(&Remark::kind, Remark::Kind::kError),
               ::testing::Field(&Remark::line, line),
               ::testing::Field(&Remark::text, HasSubstr(text)));
}
::testing::Matcher<const Remark&> Warning(int line, const std::string& text) {
  return AllOf(::testing::Field(&Remark::kind, Remark::Kind::kWarning),
               ::testing::Field(&Remark::line, line),
               ::testing::Field(&Remark::text, HasSubstr(text)));
}

// ---- Names of devices ------------------------------------------------------------------

TEST_F(ControllerCheckTest, MisspeltDevicesAreFoundWithTheNearestName) {
  EXPECT_THAT(
      Remarked("#include <device/robot.h>\n"
               "#define NECK \"PRM:/r1/c1-Joint2:j1\"\n"
               "#define MODE \"PRM:/r1/17-LED2:l7\"\n"
               "static const char* eyes[] = {\"PRM:/r1/l6-LED2:l6\", \"PRM:/r1/l6-LED:l6\"};\n"
               "/* robot_get_device(\"PRM:/r9-LED2:l9\") */\n"
               "static int run(int ms) { return 64; }\n"
               "int main(void)\n"
               "{\n"
               "    robot_get_device(NECK); robot_get_device(MODE);\n"
               "    robot_get_device ( \"RPM:/r1/c1-Joint2:j1\" );\n"
               "    robot_console_printf(\"wheel\");\n"
               "    robot_get_device(eyes[0]); robot_get_device(\"wheel\");\n"
               "    robot_run(run);\n"
               "}\n"),
      ElementsAre(Warning(3,
                          "no robot has a device 'PRM:/r1/17-LED2:l7'; it reads 0, and "
                          "what it is told goes nowhere; did you mean "
                          "'PRM:/r1/l7-LED2:l7'?"),
                  Warning(4, "did you mean 'PRM:/r1/l6-LED2:l6'?"),
                  Warning(10, "did you mean 'PRM:/r1/c1-Joint2:j1'?"),
                  Warning(12,
                          "no robot has a device 'wheel'; it reads 0, and what it is "
                          "told goes nowhere")));
}

// A part of a name, or one made up while the program runs, says nothing.
TEST_F(ControllerCheckTest, PartsOfDeviceNamesAreLeftAlone) {
  EXPECT_THAT(Remarked("#include <device/robot.h>\n"
                       "#define HEAD \"PRM:/r1/\"\n"
                       "static int run(int ms) { return 64; }\n"
                       "int main(void)\n"
                       "{\n"
                       "    char name[40];\n"
                       "    sprintf(name, \"PRM:/r1/l%d-LED2:l%d\", 7, 7);\n"
                       "    robot_get_device(HEAD \"l7-LED2:l7\");\n"
                       "    robot_get_device(\"PRM:/r1/\" \"l7-LED2:l7\");\n"
                       "    robot_run(run);\n"
                       "}\n"),
              IsEmpty());
}

// ---- robot_step() ----------------------------------------------------------------------

TEST_F(ControllerCheckTest, ALoopOfStepsIsNamedAndHowToConvertIt) {
  const std::string said = Checked(
      "#include <device/robot.h>\n"
      "/* robot_step(1) */\n"
      "#define TIME_STEP 50\n"
      "int main(void)\n"
      "{\n"
      "    for (;;) robot_step(TIME_STEP);\n"
      "}\n");
  EXPECT_THAT(said, HasSubstr("wave.c:6: warning: robot_step() works on the host only"));
  EXPECT_THAT(said, HasSubstr("let it return TIME_STEP where the loop calls "
                              "robot_step(TIME_STEP), and call robot_run(run)"));
  EXPECT_THAT(said, HasSubstr("wave.c:6: warning: a time step of 50 ms is no multiple of 8; it "
                              "becomes 48 ms\n    for (;;) robot_step(TIME_STEP);\n"
                              "                        ^\n"));
  EXPECT_THAT(Remarked(), SizeIs(2));
}

TEST_F(ControllerCheckTest, AStepBehindAMacroIsSeen) {
  EXPECT_THAT(Remarked("#include <robot.h>\n"
                       "#define FOREVER while (1)\n"
                       "#define STEP(ms) \\\n"
                       "    robot_step(ms)\n"
                       "#define ROUND STEP(50)\n"
                       "int main(void)\n"
                       "{\n"
                       "    FOREVER { ROUND; }\n"
                       "}\n"),
              ElementsAre(Warning(8, "robot_step() works on the host only"),
                          Warning(8, "a time step of 50 ms")));
}

TEST_F(ControllerCheckTest, AMacroOfAHeaderBesideTheSourceIsSeen) {
  folder.Write("steps.h", "#define WAIT robot_step(64)\n");
  EXPECT_THAT(Remarked("#include <robot.h>\n#include \"steps.h\"\n"
                       "int main(void) { for (;;) WAIT; }\n"),
              ElementsAre(Warning(3, "robot_step() works on the host only")));
}

TEST_F(ControllerCheckTest, AStepInTheRunFunctionHasItsOwnAdvice) {
  EXPECT_THAT(
      InRun("robot_step(50);"),
      ElementsAre(AllOf(Warning(4, "does nothing in the function of robot_run()"),
                        ::testing::Field(&Remark::text, HasSubstr("return the ms to wait")),
                        ::testing::Field(&Remark::text, Not(HasSubstr("body of the loop"))))));
}

TEST_F(ControllerCheckTest, AStepThatTheRunFunctionCallsIsSeenAsWell) {
  EXPECT_THAT(Remarked("#include <robot.h>\n"
                       "static void pause(void) { robot_step(64); }\n"
                       "static int run(int ms) { pause(); return 64; }\n"
                       "int main(void) { robot_run(&run); return 0; }\n"),
              ElementsAre(Warning(2, "does nothing in the function of robot_run()")));
}

TEST_F(ControllerCheckTest, AStepInTheDieFunctionHasItsOwnAdvice) {
  EXPECT_THAT(Remarked("#include <robot.h>\n"
                       "static void die(void) { robot_step(64); }\n"
                       "static int run(int ms) { return 64; }\n"
                       "int main(void) { robot_die(die); robot_run(run); return 0; }\n"),
              ElementsAre(Warning(2, "does nothing in the function of robot_die()")));
}

// ---- Time steps ------------------------------------------------------------------------

TEST_F(ControllerCheckTest, TheTimeStepOfARunFunctionIsLookedAt) {
  const std::string said = Checked(
      "#include <robot.h>\n"
      "static int helper(void) { return 50; }\n"
      "static int run(int ms)\n"
      "{\n"
      "    if (ms) return 64;\n"
      "    return 100;\n"
      "}\n"
      "int main(void) { robot_run(run); return helper(); }\n");
  EXPECT_THAT(said, HasSubstr("wave.c:6: warning: a time step of 100 ms is no multiple of 8; it "
                              "becomes 104 ms\n    return 100;\n           ^\n"));
  EXPECT_THAT(Remarked(), SizeIs(1));
}

TEST_F(ControllerCheckTest, AControllerWithoutALoopIsSaidSo) {
  EXPECT_THAT(Checked("#include <robot.h>\nint main(void) { return robot_get_mode(); }\n"),
              HasSubstr("nothing calls robot_run(): main() runs once"));
}

TEST_F(ControllerCheckTest, AControllerWithoutMainIsSaidSo) {
  EXPECT_THAT(Checked("#include <robot.h>\n"), HasSubstr("no main() in any source"));
}

// ---- Loops that never end --------------------------------------------------------------

TEST_F(ControllerCheckTest, AnEndlessLoopInMainIsAnErrorAndHasARecipe) {
  EXPECT_EQ(Checked("#include <robot.h>\n"
                    "int main(void)\n"
                    "{\n"
                    "    while (1) robot_console_printf(\"x\");\n"
                    "    robot_run(0);\n"
                    "}\n"),
            folder.File("wave.c") +
                ":4: main() never returns from this loop: no sensor changes meanwhile and no "
                "command goes out. Put the body of the loop into \"int run(int ms)\", which "
                "returns the ms until its next call, and call robot_run(run) in place of the "
                "loop\n    while (1) robot_console_printf(\"x\");\n    ^\n");
}

TEST_F(ControllerCheckTest, AnEndlessLoopInTheRunFunctionIsAnError) {
  for (const char* const loop :
       {"for (;;) ms++;", "while (1) { ms++; }", "do ms++; while (1);", "do { ms++; } while (1);",
        "for (ms = 0; 1; ms++) {}", "while (1) { while (ms) break; }",
        "while (1) switch (ms) { case 1: break; }"}) {
    EXPECT_THAT(InRun(loop), ElementsAre(Error(4, "run() never returns from this loop"))) << loop;
  }
}

TEST_F(ControllerCheckTest, ALoopBehindAMacroIsSeen) {
  EXPECT_THAT(Remarked("#include <robot.h>\n"
                       "#define TRUE 1\n"
                       "#define ALWAYS for (;;)\n"
                       "int run(int ms) { while (TRUE) ms++; }\n"
                       "int main(void) { robot_run(run); ALWAYS { } }\n"),
              ElementsAre(Error(4, "run() never"), Error(5, "main() never")));
}

TEST_F(ControllerCheckTest, ALoopThatCanEndIsNone) {
  for (const char* const loop :
       {"while (1) { if (ms++ > 3) break; }", "for (;;) if (ms++ > 3) return 64;",
        "while (1) { if (ms) { ms = 2; } else break; }", "while (0) ms++;",
        "do { ms++; } while (0);", "do { if (ms) break; } while (1);",
        "for (ms = 0; ms < 3; ms++) {}", "while (ms-- > 0) {}", "while (1) { exit(1); }"}) {
    EXPECT_THAT(InRun(loop), IsEmpty()) << loop;
  }
}

TEST_F(ControllerCheckTest, ALoopThatStepsInAFunctionIsNone) {
  EXPECT_THAT(Remarked("#include <robot.h>\n"
                       "static void wait_a_bit(void) { robot_step(64); }\n"
                       "int main(void) { while (1) wait_a_bit(); }\n"),
              ElementsAre(Warning(2, "works on the host only")));
}

TEST_F(ControllerCheckTest, WaitingForWhatDoesNotChangeIsAnError) {
  EXPECT_THAT(InRun("while (!mtn_is_over(walk));"),
              ElementsAre(Error(4, "no time passes, so what the loop waits for does not change")));
  EXPECT_THAT(InRun("do { } while (touch_sensor_get_value(paw) == 0);"),
              ElementsAre(Error(4, "Return and look at it again at its next call")));
  EXPECT_THAT(InRun("while (distance_sensor_get_value(d) < 300 && ms++ < 5) {}"), IsEmpty());
}

TEST_F(ControllerCheckTest, WhatTheCompilerDoesNotSeeIsNotLookedAt) {
  EXPECT_THAT(InRun("#if 0\nfor (;;) { system(\"ls\"); }\n#endif\n/* while (1); */"), IsEmpty());
}

// ---- Calls -----------------------------------------------------------------------------

TEST_F(ControllerCheckTest, CallsTheRobotLacksAreNamedWithTheReason) {
  EXPECT_THAT(InRun("system(\"play bark.wav\");"),
              ElementsAre(Error(4, "system(): the robot has no processes")));
  EXPECT_THAT(InRun("if (fork() == 0) ms++;"), ElementsAre(Error(4, "fork(): the robot has no")));
  EXPECT_THAT(InRun("pthread_create(&t, 0, f, 0);"),
              ElementsAre(Error(4, "pthread_create(): the robot has no threads")));
  EXPECT_THAT(InRun("int s = socket(2, 1, 0);"),
              ElementsAre(Error(4, "socket(): the robot has no sockets")));
  EXPECT_THAT(InRun("std::thread worker(f);"),
              ElementsAre(Error(4, "std::thread(): the robot has no threads")));
}

TEST_F(ControllerCheckTest, SleepingAndClocksAreWarnings) {
  EXPECT_THAT(InRun("sleep(1);"), ElementsAre(Warning(4, "sleep(): the robot has no sleep")));
  EXPECT_THAT(InRun("usleep(1000);"), ElementsAre(Warning(4, "return how long to wait, in ms")));
  EXPECT_THAT(InRun("srand(time(0));"), ElementsAre(Warning(4, "time(): the robot has no such")));
}

TEST_F(ControllerCheckTest, FunctionsOfItsOwnAreNotTakenForTheLibrarys) {
  EXPECT_THAT(Remarked("#include <robot.h>\n"
                       "static void wait(int ms) {}\n"
                       "struct Clock { int time() { return 1; } };\n"
                       "int run(int ms) { Clock c; wait(c.time()); queue.poll(); return 64; }\n"
                       "int main(void) { robot_run(run); return 0; }\n"),
              IsEmpty());
}

TEST_F(ControllerCheckTest, NamesOfFilesBeginWithTheStick) {
  EXPECT_THAT(InRun("FILE* f = fopen(\"log/walk.txt\", \"w\");"),
              ElementsAre(Error(4,
                                "'log/walk.txt' is no file of the Memory Stick: the robot has "
                                "no working folder, and names begin with /MS/. Write "
                                "\"/MS/OPEN-R/MW/DATA/P/walk.txt\"")));
  EXPECT_THAT(InRun("std::ifstream in(\"walk.txt\");"),
              ElementsAre(Error(4, "'walk.txt' is no file")));
  EXPECT_THAT(InRun("out.open(\"walk.txt\");"), ElementsAre(Error(4, "'walk.txt' is no file")));
  EXPECT_THAT(InRun("FILE* f = fopen(\"/ms/OPEN-R/MW/DATA/P/WALK.TXT\", \"w\"); fopen(name, m);"),
              IsEmpty());
  EXPECT_THAT(InRun("FILE* f = fopen(\"/MS/OPEN-R/MW/DATA/P/walking.text\", \"w\");"),
              ElementsAre(Warning(4, "'walking.text' is not an 8.3 name")));
}

TEST_F(ControllerCheckTest, TheNameOfAFileMayBeAMacro) {
  EXPECT_THAT(Remarked("#include <robot.h>\n"
                       "#define LOG \"walk.txt\"\n"
                       "int run(int ms) { fopen(LOG, \"w\"); return 64; }\n"
                       "int main(void) { robot_run(run); return 0; }\n"),
              ElementsAre(Error(3, "'walk.txt' is no file of the Memory Stick")));
}

}  // namespace
}  // namespace openr_host
