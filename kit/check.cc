#include "kit/check.h"

#include <filesystem>
#include <stdexcept>

#include "kit/check_controller.h"
#include "kit/check_data.h"
#include "kit/check_objects.h"
#include "kit/check_stick.h"
#include "kit/controller_sources.h"
#include "kit/object_parts.h"
#include "kit/project.h"
#include "kit/referred_places.h"
#include "kit/text_files.h"

namespace openr_host {

namespace fs = std::filesystem;

Remarks CheckFolder(const std::string& folder, const std::vector<std::string>& locators,
                    CheckTarget target) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw std::runtime_error(folder + ": is no folder; name a stick or a folder with objects");
  if (const std::string problem = PathReadProblem(folder); !problem.empty())
    throw std::runtime_error(folder + ": " + problem);
  Remarks unreadable;
  for (const fs::path& path : UnreadableBelow(folder))
    unreadable.Error(path.string(), PathReadProblem(path) + "; nothing else was checked");
  // Checks nothing else if files cannot be read, because the checks would report these files as
  // missing.
  if (!unreadable.all().empty()) return unreadable;
  // Scans folders outside of `folder` as well if the program names files in them with "../",
  // because these files belong to the program.  The command openr build does the same.
  const fs::path root = fs::canonical(folder);
  const ReferredPlaces places = FindReferredPlaces(root);
  const Project project = ScanProject(places.folders);
  const bool is_controller = project.objects.empty() && IsControllerFolder(folder);
  if (project.objects.empty() && project.sticks.empty() && !is_controller) {
    throw std::runtime_error(
        folder +
        ": neither objects (stub.cfg) nor a stick (OPEN-R/MW) in it or below, "
        "nor a controller (Makefile.sources, or sources that include robot.h)");
  }
  Remarks remarks(root, folder);
  if (is_controller) CheckController(folder, locators, &remarks);
  const ObjectParts parts(project, places);
  CheckObjects(project, parts, &remarks);
  CheckSentData(project, &remarks);
  for (const StickFolder& stick : project.sticks)
    CheckStick(stick, project, parts, target, &remarks);
  return remarks;
}

}  // namespace openr_host
