// The command openr check: checks a program and its Memory Stick without running the program.
#include "kit/check.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cli/colour.h"
#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

struct CheckFlags {
  std::string folder;
  bool json = false;
};

// Returns the locators of the devices of all robot models, such as "PRM:/r4/c1-Joint2:j1".  The
// check of a controller reports a call of robot_get_device() with any other locator.
std::vector<std::string> AllLocators() {
  std::vector<std::string> locators;
  for (const char* robot : {"ers210", "ers220", "ers7"}) {
    const RobotModel model = LoadRobotModel(ModelFile(robot));
    for (const JointModel& joint : model.joints) locators.push_back(joint.locator);
    for (const Led& led : model.leds) locators.push_back(led.locator);
    for (const Plunger& ear : model.plungers) locators.push_back(ear.locator);
    for (const Sensor& sensor : model.sensors) locators.push_back(sensor.locator);
    locators.push_back(model.camera.locator);
  }
  return locators;
}

int Check(const CheckFlags& flags) {
  const Remarks remarks = CheckFolder(flags.folder, AllLocators());
  if (flags.json) {
    PrintAnswer(RemarksToJson(remarks, flags.folder));
  } else {
    PrintAnswerWithCodes(fmt::format("{}{}, {}, {}\n",
                                     RenderRemarks(remarks, HasColours(StandardOutput())),
                                     Counted(remarks.CountOf(Remark::Kind::kError), "error"),
                                     Counted(remarks.CountOf(Remark::Kind::kWarning), "warning"),
                                     Counted(remarks.CountOf(Remark::Kind::kNote), "note")));
  }
  return remarks.CountOf(Remark::Kind::kError) > 0 ? kExitWrong : kExitGood;
}

}  // namespace

void AddCheckCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("check", "Looks for mistakes in objects and on a stick");
  auto flags = std::make_shared<CheckFlags>();
  flags->folder = ".";
  command->add_option("DIR", flags->folder, "A stick, or a folder with objects and sticks")
      ->capture_default_str();
  command->add_flag("--json", flags->json, "One JSON object instead of text");
  command->callback([flags, exit_code] { *exit_code = Check(*flags); });
}

}  // namespace openr_host
