// The graph of the default stick in every shipped world, on every model and on waves.  All
// models run the same images.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "runtime/base/temp_folder.h"
#include "tests/graph/graph.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Puts our motions for the ERS-7 on to the stick in place of those for the ERS-210.
void UseErs7Motions(Graph* graph) {
  for (const auto& entry : fs::directory_iterator(OPENR_ERS7_MOTIONS)) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    graph->stick().Write("/MS/OPEN-R/MW/DATA/P/" + entry.path().filename().string(), bytes);
  }
}

// Plays a motion of the stick to its end; the dog must not fall over.
void Play(Graph* graph, const std::string& file, int loops = 1) {
  graph->pilot().Play(file, loops);
  ASSERT_TRUE(graph->system().RunUntil([&] { return graph->pilot().MotionIsOver(); }, 60'000'000))
      << file;
  EXPECT_EQ(graph->console().find("not played"), std::string::npos) << graph->console();
  graph->system().RunFor(500'000);
  EXPECT_LT(std::abs(graph->RollDeg()), 25) << file;
}

struct Setting {
  std::string robot, world;
  friend void PrintTo(const Setting& setting, std::ostream* out) {
    *out << setting.robot << " in " << setting.world;
  }
};

std::string NameOf(const testing::TestParamInfo<Setting>& setting) {
  std::string name = setting.param.robot + "_" + setting.param.world;
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name;
}

class WorldsTest : public testing::TestWithParam<Setting> {};

TEST_P(WorldsTest, OurMotionsEndWithoutAnError) {
  GraphOptions options;
  options.robot = GetParam().robot;
  options.world = GetParam().world;
  Graph graph(options);
  if (options.robot == "ers7") UseErs7Motions(&graph);
  ASSERT_TRUE(graph.RunToStanding()) << graph.console() << graph.Findings();
  EXPECT_TRUE(graph.Standing());
  Play(&graph, "SIT.MTN");
  EXPECT_LT(graph.PitchDeg(), -15);  // nose up
  Play(&graph, "STAND.MTN");
  EXPECT_TRUE(graph.Standing());
  Play(&graph, "BOW.MTN");
  EXPECT_TRUE(graph.Standing());
  const double begin_m = graph.dog().body().state().X_WB.translation().x();
  Play(&graph, "WALKSTA.MTN");
  Play(&graph, "WALK.MTN", 4);
  Play(&graph, "WALKEND.MTN");
  EXPECT_GT(graph.dog().body().state().X_WB.translation().x() - begin_m, 0.15);
  Play(&graph, "LIE.MTN");
  EXPECT_FALSE(graph.system().findings().HasError()) << graph.Findings();
}

std::vector<Setting> Settings() {
  std::vector<Setting> settings;
  for (const char* const robot : {"ers210", "ers220", "ers7"}) {
    for (const char* const world :
         {"empty-room.json", "corridor.json", "ramp-and-stairs.json", "field-2004.json"}) {
      settings.push_back({robot, world});
    }
  }
  return settings;
}

INSTANTIATE_TEST_SUITE_P(Shipped, WorldsTest, testing::ValuesIn(Settings()), NameOf);

// Waves of 15 mm across the way of the dog, 400 mm apart, so that all four paws find ground.
std::string Waves() {
  std::string rows;
  for (int row = 0; row < 2; ++row) {
    std::string heights;
    for (int column = 0; column < 41; ++column) {
      const int height_mm = std::min(15, 5 * std::abs(column % 8 - 4));
      heights += fmt::format("{}{}", column == 0 ? "" : ", ", height_mm / 1000.0);
    }
    rows += fmt::format("{}[{}]", row == 0 ? "" : ", ", heights);
  }
  return fmt::format(
      R"({{"schema": "openr-host world 2", "name": "waves", "things": [)"
      R"({{"shape": "heightfield", "name": "ground", "size_m": [2, 2], "centre_m": [0.5, 0, 0], )"
      R"("heights_m": [{}]}}]}})",
      rows);
}

TEST(WavesTest, ADogStandsAndWalksOnIt) {
  const TempFolder folder;
  GraphOptions options;
  options.world = folder.path() + "/waves.json";
  std::ofstream(options.world) << Waves();
  Graph graph(options);
  ASSERT_TRUE(graph.RunToStanding()) << graph.console() << graph.Findings();
  const double height_m = graph.dog().body().state().X_WB.translation().z();
  EXPECT_GT(height_m, 0.132 + 0.003) << "the ground carries the dog";
  EXPECT_TRUE(graph.Standing());
  const double begin_m = graph.dog().body().state().X_WB.translation().x();
  Play(&graph, "WALKSTA.MTN");
  Play(&graph, "WALK.MTN", 8);
  Play(&graph, "WALKEND.MTN");
  EXPECT_GT(graph.dog().body().state().X_WB.translation().x() - begin_m, 0.1);
  EXPECT_TRUE(graph.Standing());
  EXPECT_FALSE(graph.system().findings().HasError()) << graph.Findings();
}

}  // namespace
}  // namespace openr_host
