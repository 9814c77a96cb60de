#include "openr/commands/common_flags.h"

#include <fmt/format.h>

#include <charconv>

#include "cli/counted.h"
#include "cli/install_paths.h"
#include "cli/output_file.h"
#include "openr/simulation/pacer.h"
#include "runtime/base/duration.h"

namespace openr_host {
namespace {

// Returns a check of the flag `flag`: its value must be a readable file of the user, or the name of
// a file that came with openr (DataFile()).
CLI::Validator IsDataFile(const char* flag, const InputKind& kind) {
  return CLI::Validator(
      [flag, kind](const std::string& name) -> std::string {
        const std::string file = DataFile(name);
        RefuseInput(flag, file, FileReadProblem(file, kind.kind, kind.extension));
        return "";
      },
      "");
}

// Returns a check of --stick: its value must be a folder that can be read.
CLI::Validator IsStickFolder() {
  return CLI::Validator(
      [](const std::string& folder) -> std::string {
        RefuseInput("--stick", folder, FolderReadProblem(folder, kStickKind));
        return "";
      },
      "");
}

}  // namespace

void AddCommonFlags(CLI::App* command, SimulationOptions* options) {
  command
      ->add_option_function<std::vector<std::string>>(
          "--stick",
          [options](const std::vector<std::string>& sticks) {
            options->stick = sticks.front();
            options->more_sticks.assign(sticks.begin() + 1, sticks.end());
          },
          "A folder that holds OPEN-R/ (default: the stick that came along)")
      ->check(IsStickFolder())
      ->expected(1)
      ->type_name("FOLDER");
  command->add_option("--robot", options->robot, "Model of the robot")
      ->check(CLI::IsMember({"ers210", "ers220", "ers7"}))
      ->capture_default_str();
  command
      ->add_option("--world", options->world,
                   "World file, or one of field-2004.json, empty-room.json, corridor.json, "
                   "ramp-and-stairs.json (default: a flat floor)")
      ->check(IsDataFile("--world", kWorldFile))
      ->type_name(kWorldType);
  command->add_option("--seed", options->seed, "Of everything random")
      ->check(IsCount())
      ->capture_default_str();
}

void AddRobotsFlags(CLI::App* command, SimulationOptions* options) {
  command->get_option("--stick")
      ->description(
          "A folder that holds OPEN-R/ (default: the stick that came along); may be repeated: "
          "robots take the sticks in turn")
      ->allow_extra_args(false)
      ->take_all();
  command
      ->add_option("--robots", options->robots,
                   "Number of robots; several can only read their sticks")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--together", options->together,
                    "All robots are in one world, and not each in a world of its own; needs "
                    "--body ode");
}

void CheckRobots(const SimulationOptions& options) {
  const auto sticks = static_cast<int>(options.more_sticks.size()) + 1;
  if (sticks > options.robots) {
    throw CLI::ValidationError(
        "--stick", fmt::format("{} sticks for {}; give --robots {}", sticks,
                               Counted(static_cast<size_t>(options.robots), "robot"), sticks));
  }
  if (options.together && options.body != "ode")
    throw CLI::ValidationError("--together", "needs --body ode");
}

void AddCostFlag(CLI::App* command, SimulationOptions* options) {
  const auto check = [](const std::string& name) {
    // Checks a copy of `name`, because a CLI::Validator may change the text that it checks.
    std::string checked = name;
    return name == "zero" ? "" : IsDataFile("--cost", kCostFile)(checked);
  };
  command
      ->add_option("--cost", options->cost_file,
                   "zero, or a file that says how long handlers take (ers210.cost)")
      ->check(CLI::Validator(check, ""));
}

void AddBatteryFlag(CLI::App* command, SimulationOptions* options) {
  const auto problem = [](const std::string& text) {
    Battery battery;
    return ParseBattery(text, &battery);
  };
  command
      ->add_option("--battery", options->battery,
                   "100%: full, and stays so; drain: full at boot, empty after 90 minutes; N%: so "
                   "much at boot, and drains")
      ->check(CLI::Validator(problem, ""))
      ->capture_default_str();
}

void AddImagesFlag(CLI::App* command, SimulationOptions* options) {
  const auto problem = [](const std::string& images) -> std::string {
    if (IsImageFolder(images))
      RefuseInput("--images", images, FolderReadProblem(images, "folder of pictures"));
    return "";
  };
  command
      ->add_option("--images", options->images,
                   "What cameras see: world; pattern: a test pattern; or a folder of pictures for "
                   "the first robot, in order of their names")
      ->check(CLI::Validator(problem, ""))
      ->capture_default_str();
}

CLI::Option* AddDurationFlag(CLI::App* command, const std::string& name,
                             const std::function<void(int64_t us)>& take,
                             const std::string& description) {
  const auto read = [name, take](const std::string& text) {
    int64_t us = 0;
    const std::string problem = ParseDuration(text, &us);
    if (!problem.empty()) throw CLI::ValidationError(name, problem);
    take(us);
  };
  return command->add_option_function<std::string>(name, read, description)->type_name("DURATION");
}

CLI::Option* AddDurationFlag(CLI::App* command, const std::string& name, int64_t* us,
                             const std::string& description) {
  return AddDurationFlag(
             command, name, [us](int64_t given_us) { *us = given_us; }, description)
      ->default_str(FormatDuration(*us));
}

double RateOf(const std::string& text) {
  // Returns 0, which stands for a rate without limit (RunPlan::rate).
  if (text == "max") return 0;
  char* end = nullptr;
  const double rate = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == 0 && rate >= Pacer::kRateMin && rate <= Pacer::kRateMax) return rate;
  throw CLI::ValidationError("--rate",
                             fmt::format("'{}' is neither 'max' nor a number from {} to {}", text,
                                         Pacer::kRateMin, Pacer::kRateMax));
}

CLI::Validator IsCount() {
  const auto problem = [](const std::string& text) -> std::string {
    uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc() && stop == end) return "";
    return fmt::format("'{}' is no number from 0 to {}", text, UINT64_MAX);
  };
  return CLI::Validator(problem, "UINT");
}

CLI::Validator IsWritable() { return CLI::Validator(&FileWriteProblem, "FILE"); }

void RefuseInput(const std::string& flag, const std::string& file, const std::string& problem) {
  if (problem.empty()) return;
  // Throws a plain ParseError, because CLI11 would put the flag's name before the text of a
  // ValidationError, and the text here already begins with this name.
  throw CLI::ParseError(fmt::format("{} {}: {}", flag, file, problem),
                        CLI::ExitCodes::ValidationError);
}

CLI::Validator IsReadable(const std::string& flag, const std::string& kind,
                          const std::string& extension) {
  const auto check = [flag, kind, extension](const std::string& file) -> std::string {
    RefuseInput(flag, file, FileReadProblem(file, kind, extension));
    return "";
  };
  return CLI::Validator(check, "FILE");
}

CLI::Validator IsReadable(const std::string& flag, const InputKind& kind) {
  return IsReadable(flag, kind.kind, kind.extension);
}

CLI::Validator IsFolder() { return CLI::Validator(&FolderWriteProblem, "FOLDER"); }

}  // namespace openr_host
