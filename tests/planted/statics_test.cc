// A fault that linking everything into one program hides: a static that two objects share.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/openr/program_run.h"
#include "tests/planted/planted.h"

namespace openr_host::statics_test {
namespace {

TEST(PlantedStaticsTest, AStaticThatTwoObjectsShareIsNoneOnTheRobot) {
  const ScratchFolder stick;
  stick.Write("OPEN-R/MW/CONF/OBJECT.CFG",
              "/MS/OPEN-R/MW/OBJS/SHOW.BIN\n/MS/OPEN-R/MW/OBJS/TALLY.BIN\n");
  stick.Write("OPEN-R/MW/CONF/CONNECT.CFG", "Tally.Changed.Number.S Show.Changed.Number.O\n");
  std::filesystem::create_directories(stick.File("OPEN-R/MW/OBJS"));
  for (const char* image : {"SHOW.BIN", "TALLY.BIN"}) {
    std::filesystem::copy_file(std::string(OPENR_IMAGES) + "/" + image,
                               stick.File(std::string("OPEN-R/MW/OBJS/") + image));
  }
  SimulationOptions options;
  options.stick = stick.path();
  options.body = "ideal";
  options.console = [](std::string_view) {};
  const ExplorePlan plan = PlanOf([options] { return PrepareSimulation(options); },
                                  {"eventually objects.Show.state == shows 42"});
  const Broken broken = InDefaultOrder(plan);
  EXPECT_EQ(broken.text, "not objects.Show.state == shows 42 ever: it is 'shows 0'");
  EXPECT_EQ(broken.deviations, 0u);
}

}  // namespace
}  // namespace openr_host::statics_test
