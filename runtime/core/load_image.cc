#include "runtime/core/load_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include "runtime/base/spelling.h"
#include "runtime/core/cpu.h"
#include "runtime/core/early_work.h"
#include "runtime/core/image_object.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

// Returns "; did you mean 'JOINTMOV.BIN'?" with the most similar name in the folder of `path`, a
// file of the host that does not exist.  Returns "" if no name is similar.
std::string NearestName(const std::string& path) {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(fs::path(path).parent_path(), none)) {
    if (entry.path().extension() != ".DBG") names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return DidYouMean(fs::path(path).filename().string(), names);
}

}  // namespace

std::unique_ptr<ImageObject> OpenImage(System* system, int robot, ObjectId id,
                                       const std::string& path, const std::string& where,
                                       const std::string& file, uint64_t last_box) {
  const std::string& source = file.empty() ? path : file;
  const auto refuse = [&](const std::string& why) {
    system->AddFindingAboutRobot(robot, Severity::kError,
                                 fmt::format("{}: {} {}", where, source, why));
    return nullptr;
  };
  MemoryStick* const stick = system->robot(robot).stick.get();
  if (stick == nullptr) return refuse("cannot be read: there is no Memory Stick");
  const MemoryStick::Location location = stick->Locate(source);
  if (location.error != 0 && location.error != ENOENT)
    return refuse(fmt::format("cannot be read: {}", std::strerror(location.error)));
  if (location.error != 0 || !location.exists) {
    return refuse(
        "does not exist on the stick; the robot stops with OObjectRegistry::LoadObjects() : "
        "Load() error 90" +
        NearestName(location.path));
  }
  auto image = std::make_unique<ImageObject>(system, id, robot);
  image->path = path;
  image->boxes().set_last(last_box);
  std::string problem;
  const auto load = [&] { problem = image->Load(location.path, system->run_folder()); };
  if (Object* const old = system->object(id); old != nullptr && !old->is_absent()) {
    image->KeepEarlyWork(CollectEarlyWork(image.get(), old, load));
  } else {
    load();
  }
  const auto refuse_loaded = [&](const std::string& why) {
    DropEarlyWork(image.get());
    return refuse(why);
  };
  if (!problem.empty()) return refuse_loaded(problem);
  const Object* const namesake = system->FindObject(robot, image->name);
  // Refuses the image if another object of the robot has the same name.  The name may be that of
  // object `id`, because the new image is loaded to replace this object.
  if (namesake != nullptr && namesake->id != id) {
    return refuse_loaded(fmt::format(
        "is named '{}' like another object; names in .ocf files must differ", image->name));
  }
  return image;
}

Object* LoadImage(System* system, int robot, const std::string& path, const std::string& where,
                  const std::string& file, uint64_t last_box) {
  const ObjectId id = system->object_table().IdFor(robot, path);
  auto image = OpenImage(system, robot, id, path, where, file, last_box);
  if (image == nullptr) return nullptr;
  Object* const object = system->object_table().Adopt(std::move(image));
  // Sends the messages that constructors of the image have sent to their own object.  They were
  // kept back, because the object was not in the table of objects yet.
  const CurrentScope scope(system, object);
  PostOutbox(object);
  return object;
}

}  // namespace openr_host
