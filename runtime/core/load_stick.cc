#include "runtime/core/load_stick.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <vector>

#include "runtime/base/assert.h"
#include "runtime/config/connect_config.h"
#include "runtime/config/design_config.h"
#include "runtime/config/object_config.h"
#include "runtime/config/ocf.h"
#include "runtime/core/image_file.h"
#include "runtime/core/load_image.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

constexpr char kConfFolder[] = "/MS/OPEN-R/MW/CONF/";
constexpr char kMissing[] = "No such file on the stick";

class StickLoader {
 public:
  StickLoader(System* system, int robot, const StandIns& stand_ins)
      : system_(*system),
        robot_(system->robot(robot)),
        stick_(robot_.stick.get()),
        stand_ins_(stand_ins) {}

  void CheckFiles();
  bool LoadObjects();
  void LoadConnections();
  void LoadDesign();

 private:
  std::optional<std::string> ReadConfig(const char* name) {
    return stick_ == nullptr ? std::nullopt : stick_->ReadFile(kConfFolder + std::string(name));
  }
  std::string ConfigProblem(const char* name);
  bool LoadObject(const ObjectRecord& record);
  bool LoadKept(const std::string& path, const std::string& where);
  StandIns::const_iterator FindStandIn(const std::string& path);
  std::string NameInImage(const std::string& path);
  void Report(Severity severity, std::string text) {
    system_.AddFindingAboutRobot(robot_.index, severity, std::move(text));
  }
  void Report(const std::vector<Diagnostic>& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics)
      Report(diagnostic.severity, RenderWithoutKind(diagnostic));
  }

  System& system_;
  Robot& robot_;
  MemoryStick* const stick_;
  const StandIns& stand_ins_;
};

// Returns the reason why the configuration file `name` was not read, as a text for users.  The text
// is the path of the file, and then kMissing if there is no such file, otherwise the error of the
// read.
std::string StickLoader::ConfigProblem(const char* name) {
  const int error = stick_ == nullptr ? ENOENT : stick_->ReadError(kConfFolder + std::string(name));
  const std::string why =
      error == ENOENT ? kMissing : fmt::format("cannot be read: {}", std::strerror(error));
  return fmt::format("{}{}: {}", kConfFolder, name, why);
}

// Reads the image file `path` without loading it, and returns the name of its object; "" if the
// file cannot be read.
std::string StickLoader::NameInImage(const std::string& path) {
  if (stick_ == nullptr) return "";
  const MemoryStick::Location location = stick_->Locate(path);
  if (location.error != 0 || !location.exists) return "";
  const ImageFile image = ReadImageFile(location.path);
  if (!image.problem.empty()) return "";
  const OcfResult ocf = ParseOcf(path, OcfTextOf(image.bytes));
  return ocf.ocf ? ocf.ocf->name : "";
}

StandIns::const_iterator StickLoader::FindStandIn(const std::string& path) {
  if (stand_ins_.empty()) return stand_ins_.end();
  const auto by_file = stand_ins_.find(std::filesystem::path(path).filename().string());
  // Looks for the object's name in `stand_ins_` (functions that are called instead of loading an
  // image) only if the file's name is not there, because reading the object's name from the image
  // takes time.
  return by_file != stand_ins_.end() ? by_file : stand_ins_.find(NameInImage(path));
}

bool StickLoader::LoadObject(const ObjectRecord& record) {
  if (const auto stand_in = FindStandIn(record.path); stand_in != stand_ins_.end()) {
    stand_in->second(record.path);
    return true;
  }
  const std::string where = fmt::format("{}:{}", record.place.file, record.place.line);
  return LoadImage(&system_, robot_.index, record.path, where) != nullptr ||
         LoadKept(record.path, where);
}

// Loads the image that was at `path` before an upload replaced it.  The upload has given it the
// ending .OLD.  The robot does not load this file; its boot ends without the image.  Returns false
// if the file does not exist or cannot be loaded, and always with SystemOptions::strict.
bool StickLoader::LoadKept(const std::string& path, const std::string& where) {
  if (stick_ == nullptr || system_.options().strict) return false;
  const std::string kept = std::filesystem::path(path).replace_extension(".OLD");
  const MemoryStick::Location location = stick_->Locate(kept);
  if (location.error != 0 || !location.exists) return false;
  if (LoadImage(&system_, robot_.index, path, where, kept) == nullptr) return false;
  Report(Severity::kWarning,
         fmt::format("{}: {}, the image before the last upload, is loaded instead of {}; the robot "
                     "does not do that: there the boot ends, and the robot switches itself off",
                     where, kept, path));
  return true;
}

bool StickLoader::LoadObjects() {
  const auto text = ReadConfig("OBJECT.CFG");
  if (!text) {
    std::string why = ConfigProblem("OBJECT.CFG");
    if (why.ends_with(kMissing)) why += "; a stick is a folder that holds OPEN-R/";
    Report(Severity::kError, why);
    return false;
  }
  const ObjectConfig config = ParseObjectConfig("OBJECT.CFG", *text, robot_.design);
  Report(config.diagnostics);
  if (config.objects.empty()) {
    Report(Severity::kWarning,
           "OBJECT.CFG: names no object for this robot; nothing of the application runs");
  }
  bool is_good = true;
  // Loads the other objects even if one fails, so that all problems are reported.
  for (const ObjectRecord& record : config.objects) is_good = LoadObject(record) && is_good;
  return is_good;
}

void StickLoader::LoadConnections() {
  const bool is_strict = system_.options().strict;
  const auto text = ReadConfig("CONNECT.CFG");
  if (!text) {
    // Adds only a note if CONNECT.CFG is missing, because a robot also starts without it, and old
    // programs whose objects are not connected have no such file.
    const std::string why = ConfigProblem("CONNECT.CFG");
    const Severity severity = why.ends_with(kMissing) ? Severity::kNote
                              : is_strict             ? Severity::kError
                                                      : Severity::kWarning;
    Report(severity, why + "; no object is connected");
    return;
  }
  const ConnectConfig config =
      ParseConnectConfig("CONNECT.CFG", *text, robot_.design,
                         is_strict ? " (--strict: no object starts)" : " (the line is skipped)");
  Report(config.diagnostics);
  for (const ConnectRecord& record : config.connections) {
    system_.Connect({robot_.index, Compose(record.subject), Compose(record.observer),
                     fmt::format("{}:{}", record.subject_place.file, record.subject_place.line)});
  }
}

void StickLoader::LoadDesign() {
  const auto text = ReadConfig("DESIGNDB.CFG");
  if (!text) return;
  const DesignConfig config = ParseDesignConfig("DESIGNDB.CFG", *text, robot_.design);
  Report(config.diagnostics);
  for (const DesignRecord& record : config.designs)
    robot_.design_data.emplace(record.keyword, record.path);
}

// Warns once if the stick has FIFOs, sockets or devices, which programs of the robot cannot open.
void StickLoader::CheckFiles() {
  if (stick_ == nullptr || stick_->special_files().empty()) return;
  const std::vector<std::string>& names = stick_->special_files();
  const std::string more =
      names.size() == 1 ? "" : fmt::format(" (and {} more on this stick)", names.size() - 1);
  Report(Severity::kWarning, fmt::format("/MS/{}{} is neither a file nor a folder, and a stick has "
                                         "nothing else; programs cannot open it",
                                         names.front(), more));
}

}  // namespace

bool LoadStick(System* system, int robot, StandIns stand_ins,
               const std::vector<SystemImage>& system_images) {
  for (const SystemImage& image : system_images)
    // If the caller has given a stand-in (another function for loading) for the file of this system
    // image, keeps the caller's function: emplace() then inserts nothing.
    stand_ins.emplace(image.file, [&image](const std::string&) { image.add(); });
  Robot& dog = system->robot(robot);
  ASSERT(!system->booted() || dog.powered_off, "robot {} is on already", robot);
  if (dog.stick != nullptr) dog.stick_hash = dog.stick->ContentHash();
  StickLoader loader(system, robot, stand_ins);
  loader.CheckFiles();
  const bool is_good = loader.LoadObjects();
  loader.LoadConnections();
  loader.LoadDesign();
  for (const SystemImage& image : system_images) image.check();
  return is_good;
}

}  // namespace openr_host
