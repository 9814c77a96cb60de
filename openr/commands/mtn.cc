// The command openr mtn: shows the content of motion files, and whether a robot can play these
// motions.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "MtnFile.h"
#include "RobotDescription.h"
#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/input_file.h"
#include "cli/json_text.h"
#include "cli/print_plain.h"
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"
#include "openr/commands/mtn_files.h"
#include "openr/motion/mtn_csv.h"
#include "runtime/base/read_file.h"
#include "virtualrobot/base/det_math.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegPerUrad = Degrees(1e-6);

struct MtnFlags {
  std::vector<std::string> files;
  std::string robot = "ers210";
  bool json = false;
  Json answers = Json::array();  // answers for all files; used with --json
};

// Reads the motion file `name` into `motion`.  Returns false, and sets `problem`, if the file
// cannot be read or is no motion file.
bool Load(const std::string& name, MtnFile* motion, std::string* problem) {
  *problem = FileReadProblem(name, "motion file", ".MTN");
  if (!problem->empty()) return false;
  const std::optional<std::string> bytes = ReadFile(name);
  if (!bytes) {
    *problem = fmt::format("cannot be read: {}", std::strerror(errno));
    return false;
  }
  if (motion->Read(reinterpret_cast<const Uint8*>(bytes->data()), bytes->size())) return true;
  *problem = motion->Error();
  return false;
}

Json Facts(const std::string& name, const MtnFile& motion) {
  Json joints = Json::array();
  for (int j = 0; j < motion.NumJoints(); ++j) joints.push_back(motion.Locator(j));
  return {{"file", name},
          {"name", motion.Name()},
          {"creator", motion.Creator()},
          {"design_label", motion.DesignLabel()},
          {"version", fmt::format("{}.{}", motion.MajorVersion(), motion.MinorVersion())},
          {"key_frames", motion.NumKeyFrames()},
          {"duration_ms", motion.DurationMs()},
          {"joints", joints},
          {"warnings", motion.Warnings()}};
}

std::string CountedFrames(const MtnFile& motion) {
  return Counted(static_cast<uint64_t>(motion.NumKeyFrames()), "key frame");
}

// Returns, as text, the lowest and the highest angle that the motion gives to its joint `j`.
std::string RangeOf(const MtnFile& motion, int j) {
  Sint32 low = motion.NumKeyFrames() > 0 ? motion.Angle(0, j) : 0, high = low;
  bool off = false, on = false;
  for (int k = 0; k < motion.NumKeyFrames(); ++k) {
    const Sint32 angle = motion.Angle(k, j);
    low = std::min(low, angle);
    high = std::max(high, angle);
    (angle == 0 ? off : on) = true;
  }
  if (HasTwoPositions(motion.Locator(j))) return off && on ? "off and on" : on ? "on" : "off";
  return fmt::format("{:8.2f} to {:8.2f} deg", low * kDegPerUrad, high * kDegPerUrad);
}

void PrintFacts(const std::string& name, const MtnFile& motion) {
  PrintPlain("{}: \"{}\" by \"{}\" for \"{}\", version {}.{}\n", name, motion.Name(),
             motion.Creator(), motion.DesignLabel(), motion.MajorVersion(), motion.MinorVersion());
  PrintPlain("  {} of {}, {:.3f} s\n", CountedFrames(motion),
             Counted(static_cast<uint64_t>(motion.NumJoints()), "joint"),
             motion.DurationMs() / 1000.0);
  for (int j = 0; j < motion.NumJoints(); ++j)
    PrintPlain("  {:<32} {}\n", motion.Locator(j), RangeOf(motion, j));
}

void PrintWarnings(const std::string& name, const MtnFile& motion) {
  for (const std::string& warning : motion.Warnings()) {
    PrintPlain(stderr, "{}: warning: {}\n", name, warning);
  }
}

bool Info(const std::string& name, MtnFlags* flags) {
  MtnFile motion;
  std::string problem;
  if (!Load(name, &motion, &problem)) {
    PrintPlain(stderr, "openr: {}: {}\n", name, problem);
    if (flags->json) flags->answers.push_back({{"file", name}, {"error", problem}});
    return false;
  }
  if (flags->json) {
    flags->answers.push_back(Facts(name, motion));
    return true;
  }
  PrintFacts(name, motion);
  PrintWarnings(name, motion);
  return true;
}

const RobotConstants* RobotOf(const std::string& model) {
  const std::string design = "ERS-" + model.substr(3);
  return FindRobot(design.c_str());
}

bool Check(const std::string& name, MtnFlags* flags) {
  MtnFile motion;
  std::string problem;
  const RobotConstants* const robot = RobotOf(flags->robot);
  const bool good = Load(name, &motion, &problem) && motion.MapTo(robot);
  if (!good && problem.empty()) problem = motion.Error();
  if (flags->json) {
    Json json = {{"file", name}, {"robot", robot->design}, {"plays", good}, {"error", problem}};
    json["warnings"] = motion.Warnings();
    flags->answers.push_back(json);
  } else if (good) {
    PrintPlain("{}: plays on the {}: {}, {:.3f} s\n", name, robot->design, CountedFrames(motion),
               motion.DurationMs() / 1000.0);
  }
  if (!good) PrintPlain(stderr, "openr: {}: {}\n", name, problem);
  if (!flags->json) PrintWarnings(name, motion);
  return good;
}

// Prints one line for each key frame of the motion file `name`: time, attitude and joint angles.
// Returns false after printing an error.
bool Dump(const std::string& name, MtnFlags*) {
  MtnFile motion;
  std::string problem;
  if (!Load(name, &motion, &problem)) {
    PrintPlain(stderr, "openr: {}: {}\n", name, problem);
    return false;
  }
  PrintAnswer(CsvOf(motion));
  return true;
}

using ForFile = bool (*)(const std::string& name, MtnFlags* flags);

// Prints the answers about motion files as JSON: for one file its answer, for several files a list
// of answers.
void PrintAnswers(const Json& answers) {
  const Json& document = answers.size() == 1 ? answers[0] : answers;
  PrintPlain("{}\n", JsonText(document));
}

}  // namespace

void AddMtnCommand(CLI::App* app, int* exit_code) {
  CLI::App* const mtn = app->add_subcommand("mtn", "Motion files");
  mtn->require_subcommand(1);
  auto flags = std::make_shared<MtnFlags>();
  const auto add = [&](const char* name, const char* about, ForFile for_file) {
    CLI::App* const command = mtn->add_subcommand(name, about);
    command->add_option("FILE", flags->files, "Motion files")->required();
    command->callback([flags, exit_code, for_file] {
      for (const std::string& file : flags->files) {
        if (!for_file(file, flags.get())) *exit_code = kExitWrong;
      }
      if (flags->json) PrintAnswers(flags->answers);
    });
    return command;
  };
  CLI::App* const info = add("info", "What is in a motion file", &Info);
  CLI::App* const check = add("check", "Whether a robot can play it", &Check);
  add("dump", "All key frames as comma-separated values, in degrees", &Dump);
  AddMtnFromCsvCommand(mtn, exit_code);
  AddMtnPlotCommand(mtn, exit_code);
  AddMtnOdaCommand(mtn, exit_code);
  for (CLI::App* const command : {info, check}) {
    command->add_flag("--json", flags->json,
                      "One JSON object, or a list of them for several files");
  }
  check->add_option("--robot", flags->robot, "Model of the robot")
      ->check(CLI::IsMember({"ers210", "ers220", "ers7"}))
      ->capture_default_str();
}

}  // namespace openr_host
