// The command openr model: checks how well a robot model stands, and exports the model.
#include <fmt/format.h>
#include <unistd.h>

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
#include "cli/print_plain.h"
#include "cli/progress_line.h"
#include "cli/standard_streams.h"
#include "openr/chart/chart.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/model/check_model.h"
#include "openr/model/measure.h"
#include "openr/model/show_model.h"
#include "openr/model/urdf.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

struct ModelFlags {
  std::vector<std::string> models = {"ers210", "ers220", "ers7"};
  bool json = false;
  std::string model;
  std::string file;
  std::string servo_chart, distance_chart;
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
  PrintPlain(
      "{}\n"
      "  total mass           {:8.1f} g\n"
      "  pitch                {:8.2f} degrees; kinematics {:.2f}\n"
      "  roll                 {:8.2f} degrees\n"
      "  height               {:8.2f} mm; kinematics {:.2f}\n"
      "  paws on the floor    {:8}\n"
      "  largest joint error  {:8.2f} degrees\n"
      "  drift in 60 s        {:8.2f} mm, {:.3f} degrees\n",
      model.name, check.total_mass_g, check.pitch_deg, check.stiff_pitch_deg, check.roll_deg,
      check.height_mm, check.stiff_height_mm, check.paws, check.static_error_deg_max,
      check.drift_60s_mm, check.drift_60s_deg);
  for (const std::string& problem : check.problems) PrintPlain("  problem: {}\n", problem);
}

int CheckAll(const ModelFlags& flags) {
  Json answers = Json::array();
  bool all_good = true;
  ProgressLine progress(flags.json ? -1 : STDERR_FILENO, flags.models.size(), "models");
  uint64_t checked = 0;
  for (const std::string& name : flags.models) {
    progress.Show(checked++);
    const RobotModel model = LoadRobotModel(ModelFile(name));
    const ModelCheck check = CheckModel(model);
    ClearProgressLine();
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

Json ToJson(const std::vector<StepResponse>& steps) {
  Json list = Json::array();
  for (const StepResponse& step : steps) {
    list.push_back({{"joint", step.joint},
                    {"from_deg", step.from_deg},
                    {"to_deg", step.to_deg},
                    {"rise_ms", step.rise_ms},
                    {"overshoot_deg", step.overshoot_deg},
                    {"end_error_deg", step.end_error_deg},
                    {"current_ma_max", step.current_ma_max}});
  }
  return list;
}

Json ToJson(const std::vector<DistanceReading>& readings) {
  Json list = Json::array();
  for (const DistanceReading& reading : readings) {
    list.push_back({{"distance_mm", reading.distance_mm},
                    {"reflectance", reading.reflectance},
                    {"min_mm", reading.min_mm},
                    {"mean_mm", reading.mean_mm},
                    {"max_mm", reading.max_mm}});
  }
  return list;
}

chart::Chart ChartOf(const RobotModel& model, const std::vector<StepResponse>& steps) {
  chart::Chart chart;
  chart.title = model.name + ": steps of each joint";
  chart.subtitle = "held in the air, standing; the other joints hold";
  chart.x_label = "time, ms";
  chart.y_label = "angle, degrees";
  for (const StepResponse& step : steps) {
    const std::string note = fmt::format("90 % after {:.0f} ms", step.rise_ms);
    chart.panels.push_back(
        {step.joint,
         note,
         {{chart::Look::kReference, "commanded", step.times_ms, step.commanded_deg},
          {chart::Look::kFirst, "measured", step.times_ms, step.measured_deg}}});
  }
  return chart;
}

chart::Chart ChartOf(const RobotModel& model, const std::vector<DistanceReading>& readings) {
  chart::Chart chart;
  chart.title = model.name + ": distance sensor in front of a wall";
  chart.subtitle = "200 samples at each distance";
  chart.x_label = "distance, mm";
  chart.y_label = "reading, mm";
  chart.columns = 2;
  for (const DistanceReading& reading : readings) {
    const std::string title = fmt::format("reflectance {}", reading.reflectance);
    if (chart.panels.empty() || chart.panels.back().title != title) {
      chart.panels.push_back({title,
                              "",
                              {{chart::Look::kReference, "distance", {}, {}},
                               {chart::Look::kFirst, "mean", {}, {}},
                               {chart::Look::kSecond, "smallest and largest", {}, {}},
                               {chart::Look::kSecond, "smallest and largest", {}, {}}}});
    }
    const double values[] = {reading.distance_mm, reading.mean_mm, reading.min_mm, reading.max_mm};
    for (size_t i = 0; i < std::size(values); ++i) {
      chart::Curve& curve = chart.panels.back().curves[i];
      curve.x.push_back(reading.distance_mm);
      curve.y.push_back(values[i]);
    }
  }
  return chart;
}

// Writes the chart to `file`; does nothing if `file` is "".  Throws std::runtime_error if the file
// cannot be written.
void Draw(const chart::Chart& chart, const std::string& file) {
  if (file.empty()) return;
  const std::string problem = WriteChart(chart, file);
  if (!problem.empty()) throw std::runtime_error(problem);
}

int Measure(const ModelFlags& flags) {
  constexpr double kStepDeg = 20, kBright = 1, kDark = 0.05;
  const RobotModel model = LoadRobotModel(ModelFile(flags.model));
  std::vector<DistanceReading> readings = MeasureDistances(model, kBright);
  for (const DistanceReading& reading : MeasureDistances(model, kDark)) readings.push_back(reading);
  if (readings.empty() && !flags.distance_chart.empty()) {
    throw std::runtime_error(fmt::format(
        "--distance: the model of the {} does not say where on the body a distance sensor is, so "
        "no distance can be measured",
        model.name));
  }
  const std::vector<StepResponse> steps = MeasureSteps(model, kStepDeg);
  Draw(ChartOf(model, steps), flags.servo_chart);
  Draw(ChartOf(model, readings), flags.distance_chart);
  const Json answer = {
      {"model", model.name}, {"steps", ToJson(steps)}, {"distances", ToJson(readings)}};
  PrintAnswer(JsonText(answer, 2) + "\n");
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
  CLI::App* const measure = command->add_subcommand(
      "measure", "Measures steps of the joints and the distance sensor; prints JSON");
  measure->add_option("MODEL", flags->model, "Name of a model")->required();
  measure->add_option("--servo", flags->servo_chart, "File for a chart of the steps: .svg or .png")
      ->check(CLI::Validator(&chart::ChartNameProblem, ""))
      ->check(IsWritable());
  measure
      ->add_option("--distance", flags->distance_chart,
                   "File for a chart of the distance sensor: .svg or .png")
      ->check(CLI::Validator(&chart::ChartNameProblem, ""))
      ->check(IsWritable());
  measure->callback([flags, exit_code] { *exit_code = Measure(*flags); });
  CLI::App* const show = command->add_subcommand(
      "show", "Lists what a robot has: joints, sensors, lights, with limits and CPC locators");
  show->add_option("MODEL", flags->model, "Name of a model")->required();
  show->callback([flags, exit_code] {
    PrintAnswer(TerminalText(ShowModel(LoadRobotModel(ModelFile(flags->model)))));
    *exit_code = kExitGood;
  });
  CLI::App* const urdf = command->add_subcommand("urdf", "Exports a model as URDF");
  urdf->add_option("MODEL", flags->model, "Name of a model")->required();
  urdf->add_option("-o,--output", flags->file, "File to write (default: standard output)")
      ->check(IsWritable());
  urdf->callback([flags, exit_code] { *exit_code = WriteUrdf(*flags); });
}

}  // namespace openr_host
