// The two example programs of the report (Hohl 2004, 5.3.1 and 5.3.3), on the ODE body.
#include "tests/controllers/controlled_dog.h"

namespace openr_host {
namespace {

constexpr char kLight[] = "PRM:/r1/c1/c2/c3/l7-LED2:l7";

struct Course {
  std::vector<bool> lights;  // at the end of each part
  uint64_t trace, state;
  std::string findings;
};

// Nothing near, something at the nearest that the sensor can tell, and nothing again.
Course RunCourse(const std::string& controller) {
  ControlledDog dog(controller);
  EXPECT_TRUE(dog.StandUp());
  Course course;
  for (const int32_t micrometres : {900'000, 100'000, 101'000}) {
    dog.Touch(kDistance, micrometres);
    dog.Run(1);
    course.lights.push_back(dog.Light(kLight));
  }
  EXPECT_TRUE(dog.Standing());
  course.trace = dog.trace_hash();
  course.state = dog.state_hash();
  course.findings = dog.Findings();
  return course;
}

TEST(ReportProgramTest, TheRunFunctionRuns) {
  const Course course = RunCourse("REPRUN.BIN");
  EXPECT_EQ(course.lights, (std::vector<bool>{false, true, false}));
  EXPECT_EQ(course.findings, "");
}

TEST(ReportProgramTest, TheEndlessLoopRunsAndDoesTheSameBitForBit) {
  const Course loop = RunCourse("REPLOOP.BIN");
  const Course run = RunCourse("REPRUN.BIN");
  EXPECT_EQ(loop.lights, run.lights);
  EXPECT_EQ(loop.trace, run.trace);
  EXPECT_EQ(loop.state, run.state);
  EXPECT_NE(loop.findings.find("robot_step() does not work on the robot"), std::string::npos);
}

}  // namespace
}  // namespace openr_host
