// openr model: how models stand, and their export.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "cli/install_paths.h"
#include "tests/openr/program_run.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

TEST(ModelCommandTest, AllModelsStandWell) {
  const ProgramResult result = RunProgram({"model", "check", "--json"});
  ASSERT_EQ(result.status, 0) << result.out << result.err;
  const auto models = nlohmann::json::parse(result.out);
  ASSERT_EQ(models.size(), 3u);
  EXPECT_EQ(models[0]["model"], "ERS-210");
  EXPECT_NEAR(models[0]["total_mass_g"].get<double>(), 1612, 0.01);
  EXPECT_NEAR(models[0]["stiff_pitch_deg"].get<double>(), 2.6, 0.1);
  EXPECT_NEAR(models[0]["stiff_height_mm"].get<double>(), 137.2, 0.1);
  for (const auto& model : models) {
    EXPECT_NEAR(model["pitch_deg"].get<double>(), model["stiff_pitch_deg"].get<double>(), 1);
    EXPECT_NEAR(model["height_mm"].get<double>(), model["stiff_height_mm"].get<double>(), 3);
    EXPECT_LT(model["static_error_deg_max"], 2);
    EXPECT_GT(model["static_error_deg_max"], 0.1);  // a servo without integral part gives way
    EXPECT_LT(model["drift_60s_mm"], 10);
    EXPECT_LT(model["drift_60s_deg"], 3);
    EXPECT_EQ(model["paws"], 4);
    EXPECT_TRUE(model["problems"].empty());
  }
}

TEST(ModelCommandTest, ShowListsTheDevicesWithTheirLocators) {
  const ProgramResult dog = RunProgram({"model", "show", "ers210"});
  ASSERT_EQ(dog.status, 0) << dog.err;
  EXPECT_EQ(dog.out.rfind("ERS-210, 1612 g, design ", 0), 0u) << dog.out;
  const RobotModel model = LoadRobotModel(ModelFile("ers210"));
  for (const Sensor& sensor : model.sensors) {
    EXPECT_NE(dog.out.find(" " + sensor.locator + "\n"), std::string::npos) << sensor.locator;
  }
  for (const Led& led : model.leds)
    EXPECT_NE(dog.out.find(led.locator), std::string::npos) << led.locator;
  EXPECT_NE(dog.out.find("  neck_tilt         0   -82.0 to 43.0   -85.0 to 46.0      120.6       "
                         "0.50  PRM:/r1/c1-Joint2:j1\n"),
            std::string::npos)
      << dog.out;
  EXPECT_NE(dog.out.find("  chin                  7                  0 to 1"), std::string::npos);
}

TEST(ModelCommandTest, AnUnknownModelIsRefused) {
  const ProgramResult result = RunProgram({"model", "show", "ers999"});
  EXPECT_NE(result.status, 0);
  EXPECT_NE(result.err.find("ers999"), std::string::npos) << result.err;
}

TEST(ModelCommandTest, AChartOfAnotherKindIsRefusedBeforeTheMeasurement) {
  for (const char* const flag : {"--servo", "--distance"}) {
    const ProgramResult result =
        RunProgram({"model", "measure", "ers210", flag, testing::TempDir() + "chart.pdf"});
    EXPECT_EQ(result.status, 2) << flag;
    EXPECT_NE(result.err.find("ends in .svg or .png"), std::string::npos) << result.err;
  }
}

TEST(ModelCommandTest, NoChartIsDrawnOfADistanceSensorWithoutAPlace) {
  const std::string file = testing::TempDir() + "model_command_test_distance.svg";
  const ProgramResult result = RunProgram({"model", "measure", "ers220", "--distance", file});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("the model of the ERS-220 does not say where"), std::string::npos)
      << result.err;
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(ModelCommandTest, TextSaysTheSame) {
  const ProgramResult result = RunProgram({"model", "check", "ers210"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.out.find("total mass             1612.0 g\n"), std::string::npos) << result.out;
}

TEST(ModelCommandTest, ModelsThatCannotBeCheckedAreNamed) {
  const ProgramResult unknown = RunProgram({"model", "urdf", "ers9"});
  EXPECT_EQ(unknown.status, 1);
  EXPECT_NE(unknown.err.find("no robot model 'ers9'; there are: ers210, ers220, ers7"),
            std::string::npos)
      << unknown.err;
}

// Returns the numbers that `pattern` finds in its first group, in the order of the text.
std::vector<double> Numbers(const std::string& text, const std::string& pattern) {
  std::vector<double> numbers;
  const std::regex regex(pattern);
  for (auto at = std::sregex_iterator(text.begin(), text.end(), regex);
       at != std::sregex_iterator(); ++at)
    numbers.push_back(std::stod((*at)[1]));
  return numbers;
}

TEST(ModelCommandTest, UrdfHasTheNumbersOfTheModel) {
  const RobotModel model = LoadRobotModel(std::string(OPENR_MODEL_DIR) + "/ers210.json");
  const ProgramResult result = RunProgram({"model", "urdf", "ers210"});
  ASSERT_EQ(result.status, 0) << result.err;
  const std::vector<double> masses = Numbers(result.out, "<mass value=\"([^\"]*)\"");
  EXPECT_NE(result.out.find("<link name=\"camera_optical\"/>"), std::string::npos);
  const std::vector<double> lower = Numbers(result.out, "<limit lower=\"([^\"]*)\"");
  const std::vector<double> upper = Numbers(result.out, "upper=\"([^\"]*)\"");
  const std::vector<double> effort = Numbers(result.out, "effort=\"([^\"]*)\"");
  const std::vector<double> velocity = Numbers(result.out, "velocity=\"([^\"]*)\"");
  ASSERT_EQ(masses.size(), model.bodies.size());
  ASSERT_EQ(lower.size(), model.joints.size());
  for (size_t i = 0; i < masses.size(); ++i) EXPECT_EQ(masses[i], model.bodies[i].mass_kg);
  for (size_t j = 0; j < lower.size(); ++j) {
    EXPECT_EQ(lower[j], model.joints[j].hard_rad.min);
    EXPECT_EQ(upper[j], model.joints[j].hard_rad.max);
    EXPECT_EQ(effort[j], model.joints[j].stall_torque_nm);
    EXPECT_EQ(velocity[j], model.joints[j].speed_rad_s.max);
  }
}

TEST(ModelCommandTest, APublicParserLoadsTheUrdf) {
  const std::string parser = "/usr/bin/check_urdf";
  if (!std::filesystem::exists(parser)) GTEST_SKIP() << "no check_urdf (liburdfdom-tools)";
  const std::string file = testing::TempDir() + "model_command_test.urdf";
  for (const char* const name : {"ers210", "ers220", "ers7"}) {
    ASSERT_EQ(RunProgram({"model", "urdf", name, "-o", file}).status, 0);
    const ProgramResult parsed = ProgramRun({file}, parser).Finish();
    EXPECT_EQ(parsed.status, 0) << parsed.out << parsed.err;
    EXPECT_NE(parsed.out.find("root Link: base_link has 1 child"), std::string::npos)
        << parsed.out << parsed.err;
  }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace openr_host
