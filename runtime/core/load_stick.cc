// From a Memory Stick to objects and wires.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "runtime/base/spelling.h"
#include "runtime/config/connect_config.h"
#include "runtime/config/design_config.h"
#include "runtime/config/object_config.h"
#include "runtime/config/ocf.h"
#include "runtime/core/image.h"
#include "runtime/core/image_file.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

constexpr char kConfFolder[] = "/MS/OPEN-R/MW/CONF/";
constexpr char kMissing[] = "No such file on the stick";

std::string FileName(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

// "; did you mean 'JOINTMOV.BIN'?" after the files that lie where `path`, a file of the host, does
// not.
std::string NearestName(const std::string& path) {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(fs::path(path).parent_path(), none)) {
    if (entry.path().extension() != ".DBG") names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return DidYouMean(FileName(path), names);
}

}  // namespace

void System::AddDiagnostics(int robot, const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) {
    findings_.Add({diagnostic.severity, robot, "", 0, now_us_, RenderWithoutKind(diagnostic)});
  }
}

std::unique_ptr<ImageObject> System::OpenImage(int robot_index, ObjectId id,
                                               const std::string& path, const std::string& where) {
  const auto refuse = [&](const std::string& why) {
    findings_.Add({Severity::kError, robot_index, "", 0, now_us_,
                   fmt::format("{}: {} {}", where, path, why)});
    return nullptr;
  };
  MemoryStick* const stick = robot(robot_index).stick.get();
  if (stick == nullptr) return refuse("cannot be read: there is no Memory Stick");
  const MemoryStick::Location location = stick->Locate(path);
  if (location.error != 0 && location.error != ENOENT)
    return refuse(fmt::format("cannot be read: {}", std::strerror(location.error)));
  if (location.error != 0 || !location.exists) {
    return refuse(
        "does not exist on the stick; the robot stops with OObjectRegistry::LoadObjects() : "
        "Load() error 90" +
        NearestName(location.path));
  }
  if (run_folder_ == nullptr) run_folder_ = std::make_unique<RunFolder>();
  auto image = std::make_unique<ImageObject>(this, id, robot_index);
  image->path = path;
  const std::string problem = image->Load(location.path, run_folder_.get());
  if (!problem.empty()) return refuse(problem);
  const Object* const namesake = FindObject(robot_index, image->name);
  if (namesake != nullptr && namesake->id != id) {
    return refuse(fmt::format("is named '{}' like another object; names in .ocf files must differ",
                              image->name));
  }
  return image;
}

Object* System::LoadImage(int robot_index, const std::string& path, const std::string& where) {
  auto image = OpenImage(robot_index, static_cast<ObjectId>(objects_.size()), path, where);
  return image == nullptr ? nullptr : Adopt(std::move(image));
}

std::unique_ptr<Object> System::LoadAgain(const Object& object) {
  return OpenImage(object.robot, object.id, object.path, "reload");
}

std::optional<std::string> System::ReadConfig(int robot_index, const char* name) {
  MemoryStick* const stick = robot(robot_index).stick.get();
  return stick == nullptr ? std::nullopt : stick->ReadFile(kConfFolder + std::string(name));
}

// The name of the object whose image it is, which is not loaded; "" when that cannot be told.
std::string System::NameInImage(int robot_index, const std::string& path) {
  MemoryStick* const stick = robot(robot_index).stick.get();
  if (stick == nullptr) return "";
  const MemoryStick::Location location = stick->Locate(path);
  if (location.error != 0 || !location.exists) return "";
  const ImageFile image = ReadImageFile(location.path);
  if (!image.problem.empty()) return "";
  const OcfResult ocf = ParseOcf(path, OcfTextOf(image.bytes));
  return ocf.ocf ? ocf.ocf->name : "";
}

// kMissing or what keeps it from being read.
std::string System::WhyNoConfig(int robot_index, const char* name) {
  MemoryStick* const stick = robot(robot_index).stick.get();
  const int error = stick == nullptr ? ENOENT : stick->WhyUnread(kConfFolder + std::string(name));
  const std::string why =
      error == ENOENT ? kMissing : fmt::format("cannot be read: {}", std::strerror(error));
  return fmt::format("{}{}: {}", kConfFolder, name, why);
}

bool System::LoadObjects(int robot_index, const StandIns& stand_ins) {
  const auto text = ReadConfig(robot_index, "OBJECT.CFG");
  if (!text) {
    std::string why = WhyNoConfig(robot_index, "OBJECT.CFG");
    if (why.ends_with(kMissing)) why += "; a stick is a folder that holds OPEN-R/";
    findings_.Add({Severity::kError, robot_index, "", 0, now_us_, why});
    return false;
  }
  const ObjectConfig config = ParseObjectConfig("OBJECT.CFG", *text, robot(robot_index).design);
  AddDiagnostics(robot_index, config.diagnostics);
  if (config.objects.empty()) {
    findings_.Add({Severity::kWarning, robot_index, "", 0, now_us_,
                   "OBJECT.CFG: names no object for this robot; nothing of the application runs"});
  }
  bool good = true;
  for (const ObjectRecord& record : config.objects) {
    if (const auto found = stand_ins.find(FileName(record.path)); found != stand_ins.end()) {
      found->second(record.path);
      continue;
    }
    if (const auto found = stand_ins.empty()
                               ? stand_ins.end()
                               : stand_ins.find(NameInImage(robot_index, record.path));
        found != stand_ins.end()) {
      found->second(record.path);
      continue;
    }
    auto image = OpenImage(robot_index, static_cast<ObjectId>(objects_.size()), record.path,
                           fmt::format("{}:{}", record.place.file, record.place.line));
    if (image == nullptr) {
      good = false;
    } else {
      Adopt(std::move(image));
    }
  }
  return good;
}

void System::LoadConnections(int robot_index) {
  const auto text = ReadConfig(robot_index, "CONNECT.CFG");
  if (!text) {
    // Programs that use no service of another object came without the file; the robot starts them.
    const std::string why = WhyNoConfig(robot_index, "CONNECT.CFG");
    const Severity severity = why.ends_with(kMissing) ? Severity::kNote
                              : options_.strict       ? Severity::kError
                                                      : Severity::kWarning;
    findings_.Add({severity, robot_index, "", 0, now_us_, why + "; no object is connected"});
    return;
  }
  const ConnectConfig config = ParseConnectConfig(
      "CONNECT.CFG", *text, robot(robot_index).design,
      options_.strict ? " (--strict: no object starts)" : " (the line is skipped)");
  AddDiagnostics(robot_index, config.diagnostics);
  for (const ConnectRecord& record : config.connections) {
    Connect({robot_index, Compose(record.subject), Compose(record.observer),
             fmt::format("{}:{}", record.subject_place.file, record.subject_place.line)});
  }
}

bool System::LoadStick(int robot_index, const StandIns& stand_ins) {
  Robot& dog = robot(robot_index);
  if (dog.stick != nullptr) dog.stick_hash = dog.stick->ContentHash();
  const bool good = LoadObjects(robot_index, stand_ins);
  LoadConnections(robot_index);
  if (const auto text = ReadConfig(robot_index, "DESIGNDB.CFG")) {
    const DesignConfig config = ParseDesignConfig("DESIGNDB.CFG", *text, dog.design);
    AddDiagnostics(robot_index, config.diagnostics);
    for (const DesignRecord& record : config.designs)
      dog.design_data.emplace(record.keyword, record.path);
  }
  return good;
}

}  // namespace openr_host
