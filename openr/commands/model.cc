// The command openr model: checks how a robot model stands, and exports it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/model/check_model.h"
#include "openr/model/urdf.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

struct ModelFlags {
  std::vector<std::string> models = {"ers210", "ers220", "ers7"};
  bool json = false;
  std::string model;
  std::string file;
};

Json ToJson(const RobotModel& model, const ModelCheck& check) {
  return {{"model", model.name},
          {"total_mass_g", check.total_mass_g},
          {"pitch_deg", check.pitch_deg},
          {"roll_deg", check.roll_deg},
          {"height_mm", check.height_mm},
          {"paws", check.paws},
          {"stiff_pitch_deg", check.stiff_pitch_deg},
          {"stiff_height_mm", check.stiff_height_mm},
          {"static_error_deg_max", check.static_error_deg_max},
          {"drift_60s_mm", check.drift_60s_mm},
          {"drift_60s_deg", check.drift_60s_deg},
          {"problems", check.problems}};
}

void Print(const RobotModel& model, const ModelCheck& check) {
  std::printf("%s",
              fmt::format("{}\n"
                          "  total mass           {:8.1f} g\n"
                          "  pitch                {:8.2f} degrees; kinematics {:.2f}\n"
                          "  roll                 {:8.2f} degrees\n"
                          "  height               {:8.2f} mm; kinematics {:.2f}\n"
                          "  paws on the floor    {:8}\n"
                          "  largest joint error  {:8.2f} degrees\n"
                          "  drift in 60 s        {:8.2f} mm, {:.3f} degrees\n",
                          model.name, check.total_mass_g, check.pitch_deg, check.stiff_pitch_deg,
                          check.roll_deg, check.height_mm, check.stiff_height_mm, check.paws,
                          check.static_error_deg_max, check.drift_60s_mm, check.drift_60s_deg)
                  .c_str());
  for (const std::string& problem : check.problems) std::printf("  problem: %s\n", problem.c_str());
}

int CheckAll(const ModelFlags& flags) {
  Json answers = Json::array();
  bool all_good = true;
  for (const std::string& name : flags.models) {
    const RobotModel model = LoadRobotModel(ModelFile(name));
    const ModelCheck check = CheckModel(model);
    all_good = all_good && check.problems.empty();
    if (flags.json) {
      answers.push_back(ToJson(model, check));
    } else {
      Print(model, check);
    }
  }
  if (flags.json) PrintAnswer(JsonText(answers, 2) + "\n");
  return all_good ? kExitGood : kExitWrong;
}

int WriteUrdf(const ModelFlags& flags) {
  const std::string text = Urdf(LoadRobotModel(ModelFile(flags.model)));
  if (flags.file.empty()) {
    PrintAnswer(text);
    return kExitGood;
  }
  const std::string problem = WriteFile(flags.file, text);
  if (!problem.empty()) throw std::runtime_error(problem);
  return kExitGood;
}

}  // namespace

void AddModelCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand("model", "Models of robots");
  command->require_subcommand(1);
  const auto flags = std::make_shared<ModelFlags>();
  CLI::App* const check = command->add_subcommand(
      "check", "Stands models up with physics; status 1 if one does not stand well");
  check->add_option("MODEL", flags->models, "Names of models")->capture_default_str();
  check->add_flag("--json", flags->json, "One JSON array");
  check->callback([flags, exit_code] { *exit_code = CheckAll(*flags); });
  CLI::App* const urdf = command->add_subcommand("urdf", "Exports a model as URDF");
  urdf->add_option("MODEL", flags->model, "Name of a model")->required();
  urdf->add_option("-o,--output", flags->file, "File to write (default: standard output)")
      ->check(IsWritable());
  urdf->callback([flags, exit_code] { *exit_code = WriteUrdf(*flags); });
}

}  // namespace openr_host
