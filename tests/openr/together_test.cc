// Several robots in one world: runs, recordings, sticks, inputs about things, refusals.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/install_paths.h"
#include "openr/inspect/recorder.h"
#include "openr/inspect/replayer.h"
#include "openr/simulation/run_stick.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/temp_folder.h"
#include "runtime/core/system.h"
#include "tests/openr/program_run.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {
namespace {

SimulationOptions OnTheField(int robots) {
  SimulationOptions options;
  options.world = "field-2004.json";
  options.robots = robots;
  options.together = true;
  options.host_network = false;
  options.console = [](std::string_view) {};
  return options;
}

// Returns a copy of the default stick in `folder`, with one file more.
std::string StickWith(const TempFolder& folder, const std::string& name) {
  const std::filesystem::path stick = std::filesystem::path(folder.path()) / name;
  std::filesystem::create_directory(stick);
  CopyStick(StickFolder(""), stick);
  std::ofstream(stick / "OPEN-R" / "MW" / "CONF" / "TEAM.CFG") << name << "\n";
  return stick;
}

TEST(TogetherTest, RobotsBeginAtTheStartsOfTheWorldAndSeeEachOther) {
  Simulation simulation(OnTheField(2));
  const auto place = [&](int robot) {
    return simulation.robots()[static_cast<size_t>(robot)]->body().state().X_WB.translation();
  };
  EXPECT_NEAR(place(0).x(), 0, 0.03);
  EXPECT_NEAR(place(1).x(), 1.7, 0.03);
  EXPECT_TRUE(simulation.is_together());
  const Body& first = simulation.robots()[0]->body();
  const size_t things = simulation.world().things.size();
  EXPECT_GT(first.Surroundings().size(), things + 10);
  EXPECT_EQ(first.MovableThings().size(), 1u);
}

TEST(TogetherTest, TwoRunsOfEightDogsAreEqualAndAReplayIs) {
  const TempFolder folder;
  const std::string file = folder.path() + "/run.rec";
  uint64_t hashes[2];
  for (uint64_t& hash : hashes) {
    const SimulationOptions plain = OnTheField(8);
    SimulationOptions options = plain;
    Recorder recorder(file, true);
    recorder.RecordNetworks(&options);
    Simulation simulation(options);
    recorder.Begin(&simulation, plain, simulation.stick());
    System& system = simulation.system();
    system.Boot();
    system.RunUntil(1'000'000);
    EXPECT_EQ(system.inputs().Add(3, "put ball 1.1 -0.55 0.3"), "");  // on to robot 3
    EXPECT_EQ(system.inputs().Add(2, "push 0 9 0"), "");
    system.RunUntil(4'000'000);
    EXPECT_EQ(recorder.Finish(&system), "");
    hash = system.state_hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  Replayer replayer({.file = file, .stick = "", .console = [](std::string_view) {}});
  replayer.RunUntil(INT64_MAX);
  EXPECT_EQ(replayer.difference(), "");
  EXPECT_TRUE(replayer.at_end());
  EXPECT_TRUE(replayer.problems().empty());
  EXPECT_EQ(replayer.system().state_hash(), hashes[0]);
}

// The second robot is 1.7 m away, too far for the distance sensor.
TEST(TogetherTest, ADistantRobotDoesNotMoveTheFirst) {
  const auto place_after = [](int robots) {
    Simulation simulation(OnTheField(robots));
    simulation.system().Boot();
    simulation.system().RunUntil(2'000'000);
    return simulation.robots()[0]->body().state().X_WB.matrix();
  };
  EXPECT_EQ(place_after(1), place_after(2));
}

TEST(TogetherTest, RobotsTakeTheSticksInTurn) {
  const TempFolder folder;
  SimulationOptions options = OnTheField(3);
  options.stick = StickWith(folder, "red");
  options.more_sticks = {StickWith(folder, "blue")};
  Simulation simulation(options);
  EXPECT_EQ(simulation.StickOf(0), options.stick);
  EXPECT_EQ(simulation.StickOf(1), options.more_sticks[0]);
  EXPECT_EQ(simulation.StickOf(2), options.stick);
  const System& system = simulation.system();
  EXPECT_EQ(system.robot(0).stick_hash, system.robot(2).stick_hash);
  EXPECT_NE(system.robot(0).stick_hash, system.robot(1).stick_hash);
}

TEST(TogetherTest, AReplayNeedsTheSticksOfThen) {
  const TempFolder folder;
  const std::string file = folder.path() + "/run.rec";
  SimulationOptions options = OnTheField(2);
  options.stick = StickWith(folder, "red");
  options.more_sticks = {StickWith(folder, "blue")};
  {
    const SimulationOptions plain = options;
    Recorder recorder(file, true);
    recorder.RecordNetworks(&options);
    Simulation simulation(options);
    recorder.Begin(&simulation, plain, simulation.stick());
    simulation.system().Boot();
    simulation.system().RunUntil(500'000);
    EXPECT_EQ(recorder.Finish(&simulation.system()), "");
  }
  const auto replay = [&file] {
    Replayer replayer({.file = file, .stick = "", .console = [](std::string_view) {}});
    replayer.RunUntil(INT64_MAX);
    return replayer.difference();
  };
  EXPECT_EQ(replay(), "");
  std::ofstream(options.more_sticks[0] + "/OPEN-R/MW/CONF/TEAM.CFG") << "green\n";
  try {
    replay();
    FAIL() << "the changed stick was not seen";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), file + ": was recorded with other files on the stick of robot 1 than " +
                                options.more_sticks[0] +
                                " has now; put the files of then back there");
  }
}

TEST(TogetherTest, AFaultIsOfOneRobotAndAReplayHasIt) {
  const TempFolder folder;
  const std::string file = folder.path() + "/run.rec";
  const auto height_m = [](const Simulation& simulation, int robot) {
    const Body& body = simulation.robots()[static_cast<size_t>(robot)]->body();
    return body.state().X_WB.translation().z();
  };
  uint64_t hash = 0;
  {
    const SimulationOptions plain = OnTheField(2);
    SimulationOptions options = plain;
    Recorder recorder(file, true);
    recorder.RecordNetworks(&options);
    Simulation simulation(options);
    recorder.Begin(&simulation, plain, simulation.stick());
    System& system = simulation.system();
    system.Boot();
    system.RunUntil(14'000'000);
    EXPECT_GT(height_m(simulation, 1), 0.12);
    for (const char* const joint : {"LF_j1", "RF_j1", "LF_j3", "RF_j3"}) {
      const std::string line = std::string("break ") + joint + " unpowered for 1500ms";
      EXPECT_EQ(system.inputs().Add(1, line), "");
    }
    system.RunUntil(15'000'000);
    EXPECT_GT(height_m(simulation, 0), 0.12);
    EXPECT_LT(height_m(simulation, 1), 0.11);
    EXPECT_EQ(recorder.Finish(&system), "");
    hash = system.state_hash();
  }
  Replayer replayer({.file = file, .stick = "", .console = [](std::string_view) {}});
  replayer.RunUntil(INT64_MAX);
  EXPECT_EQ(replayer.difference(), "");
  EXPECT_EQ(replayer.system().state_hash(), hash);
}

TEST(TogetherTest, PutMovesAThingAndRefusesWhatItCannotMove) {
  Simulation simulation(OnTheField(1));
  System& system = simulation.system();
  system.Boot();
  EXPECT_EQ(system.inputs().Add(0, "put ball -0.5 0.25"), "");
  system.RunUntil(100'000);
  const WorldThing ball = simulation.robots()[0]->body().MovableThings()[0];
  EXPECT_NEAR(ball.centre_m.x(), -0.5, 1e-3);
  EXPECT_NEAR(ball.centre_m.y(), 0.25, 1e-3);
  const auto refusal = [&system](const std::string& line) { return system.inputs().Add(0, line); };
  EXPECT_NE(refusal("put bal 1 0").find("the world has no movable thing 'bal'"), std::string::npos);
  EXPECT_NE(refusal("put halfway line 1 0").find("no movable thing 'halfway'"), std::string::npos);
  EXPECT_NE(refusal("put ball 1").find("needs the name of a thing, and x and y in m"),
            std::string::npos);
  EXPECT_NE(refusal("put ball 1000 0").find("1000 m is too far away, at most 100 m"),
            std::string::npos);
}

TEST(TogetherTest, ANameOfSeveralWordsAndANumberIsPut) {
  const TempFolder folder;
  const std::string file = folder.path() + "/two.json";
  std::ofstream(file) << R"({"schema": "openr-host world 2", "name": "two", "things": [
      {"shape": "sphere", "name": "ball", "radius_m": 0.04, "centre_m": [1, 0, 0.04], "mass_kg": 0.1},
      {"shape": "sphere", "name": "ball 2", "radius_m": 0.04, "centre_m": [1, 1, 0.04], "mass_kg": 0.1}
    ]})";
  SimulationOptions options = OnTheField(1);
  options.world = file;
  Simulation simulation(options);
  simulation.system().Boot();
  EXPECT_EQ(simulation.system().inputs().Add(0, "put ball 2 -1 0.5 0.04"), "");
  simulation.system().RunUntil(100'000);
  const std::vector<WorldThing> things = simulation.robots()[0]->body().MovableThings();
  EXPECT_NEAR(things[0].centre_m.x(), 1, 1e-3);
  EXPECT_NEAR(things[1].centre_m.x(), -1, 1e-3);
}

// The frames of the robot that is on move the body of the other one, too.
TEST(TogetherTest, ARobotThatIsOffGoesLimpWhileAnotherIsOn) {
  Simulation simulation(OnTheField(2));
  System& system = simulation.system();
  system.Boot();
  system.RunUntil(14'000'000);
  const auto height_m = [&](int robot) {
    const Body& body = simulation.robots()[static_cast<size_t>(robot)]->body();
    return body.state().X_WB.translation().z();
  };
  EXPECT_GT(height_m(1), 0.12);
  EXPECT_EQ(system.inputs().Add(1, "shutdown"), "");
  system.RunUntil(18'000'000);
  EXPECT_TRUE(system.robot(1).powered_off);
  EXPECT_LT(height_m(1), 0.1);
  EXPECT_GT(height_m(0), 0.12);
}

TEST(TogetherTest, TheReportSaysWhereThingsAre) {
  ProgramRun run({"run", "--robots", "2", "--together", "--world", "field-2004.json", "--for", "1s",
                  "--rate", "max", "--json", "--rc-port", "0", "--no-panel"});
  const ProgramResult& result = run.Finish();
  ASSERT_EQ(result.status, 0) << result.err;
  const auto report = nlohmann::json::parse(result.out);
  for (const auto& robot : report.at("robots")) {
    ASSERT_EQ(robot.at("things").size(), 1u);
    EXPECT_EQ(robot["things"][0]["name"], "ball");
    EXPECT_NEAR(robot["things"][0]["position_m"][0].get<double>(), 1, 1e-3);
  }
}

TEST(TogetherTest, FlagsThatDoNotFitAreRefused) {
  const auto refusal = [](const std::vector<std::string>& flags) {
    std::vector<std::string> arguments = {"run", "--for", "1s", "--no-panel", "--rc-port", "0"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    ProgramRun run(arguments);
    const ProgramResult& result = run.Finish();
    EXPECT_NE(result.status, 0);
    return result.err;
  };
  EXPECT_NE(refusal({"--robots", "2", "--together", "--body", "ideal"})
                .find("--together: needs --body ode"),
            std::string::npos);
  EXPECT_NE(refusal({"--stick", ".", "--stick", "."}).find("2 sticks for 1 robot; give --robots 2"),
            std::string::npos);
  EXPECT_NE(refusal({"--robots", "9", "--together", "--world", "field-2004.json"})
                .find("has places for 8 robots (starts); robot 8 has none"),
            std::string::npos);
}

}  // namespace
}  // namespace openr_host
