#include "kit/complete_stick.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "cli/copy_file.h"
#include "cli/output_file.h"
#include "kit/image_match.h"
#include "kit/text_files.h"
#include "runtime/base/spelling.h"
#include "runtime/config/gateway_config.h"
#include "runtime/config/ocf.h"
#include "runtime/core/image_file.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// An image of this build: its entry in the log of the build, the content of its file, and the names
// under which OBJECT.CFG may mention the image, such as the names of its object, class, file and
// folder.
struct BuiltImage {
  KitLog::Image log;
  std::string bytes;
  std::vector<std::string> names;
};

std::string UpperCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// Returns the files in `folder`, sorted by name; none if there is no such folder.
std::vector<fs::path> FilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file(error)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// Returns the files in the folder for images (OPEN-R/MW/OBJS) of `stick`.
std::vector<fs::path> InstalledFiles(const StickFolder& stick) {
  return FilesIn(stick.ObjectsFolder());
}

std::vector<BuiltImage> ReadBuiltImages(const KitLog& log, const Project& project) {
  std::vector<BuiltImage> images;
  // Collects names and contents of the files on sticks.  An image of this build may be on a stick
  // under another name, which OBJECT.CFG uses; its content shows that it is the same image.
  std::vector<std::pair<std::string, std::string>> installed;
  for (const StickFolder& stick : project.sticks) {
    for (const fs::path& file : InstalledFiles(stick))
      installed.emplace_back(file.filename(), ReadImageFile(file).bytes);
  }
  for (const KitLog::Image& entry : log.images) {
    BuiltImage image{entry, ReadImageFile(entry.file).bytes, {}};
    const fs::path folder = fs::path(entry.ocf).parent_path();
    // Adds a dot to the last of these names, the folder's, because Normalised() removes everything
    // from the last dot on as an extension.
    image.names = {entry.object, fs::path(entry.file).filename(), fs::path(entry.ocf).filename(),
                   folder.filename().string() + "."};
    for (const ObjectFolder& object : project.objects) {
      if (object.folder != folder) continue;
      if (!object.class_name.empty()) image.names.push_back(object.class_name);
      image.names.insert(image.names.end(), object.image_names.begin(), object.image_names.end());
    }
    for (const auto& [name, bytes] : installed)
      if (bytes == image.bytes) image.names.push_back(name);
    images.push_back(std::move(image));
  }
  return images;
}

class StickCompletion {
 public:
  StickCompletion(const StickFolder& stick, const Project& project, const KitLog& log,
                  const std::string& sdk_root, const fs::path& users_stick)
      : stick_(stick),
        project_(project),
        objects_(stick.ObjectsFolder()),
        sdk_root_(sdk_root),
        users_stick_(users_stick),
        built_(ReadBuiltImages(log, project)),
        has_failures_(built_.size() < project.objects.size()) {}

  CompletedStick Run() {
    FindInstalled();
    if (stick_.objects.empty()) {
      ListEverything();
    } else {
      MatchTheRest();
    }
    for (const size_t index : used_) completed_.used.insert(built_[index].log.file);
    return std::move(completed_);
  }

 private:
  static constexpr size_t kNone = static_cast<size_t>(-1);

  size_t IndexOf(const std::string& bytes) const {
    for (size_t i = 0; i < built_.size(); ++i) {
      if (built_[i].bytes == bytes) return i;
    }
    return kNone;
  }

  // Finds the images that rules of Makefiles have put on the stick.  Adds the names of all other
  // images in OBJECT.CFG to `missing_`.
  void FindInstalled() {
    for (const ObjectRecord& record : stick_.objects) {
      const std::string name = FileNameOf(record);
      if (EqualsIgnoringCase(name, kGatewayImage)) {
        completed_.images.push_back({name, "", "the runtime's own"});
        continue;
      }
      const fs::path place = PlaceOf(record);
      const ImageFile image =
          place.empty() ? ImageFile{"", false, false, "is missing"} : ReadImageFile(place);
      if (!image.problem.empty()) {
        missing_.push_back(name);
        is_for_robot_[name] = image.is_for_robot;
        continue;
      }
      const size_t index = IndexOf(image.bytes);
      if (index != kNone) used_.insert(index);
      completed_.images.push_back(
          {name, index == kNone ? "" : built_[index].log.object, "Makefile"});
    }
  }

  // Returns the path of the image that `record`, a line of OBJECT.CFG, names; "" if this image is
  // not on the stick.  The image may be in another folder of the stick than OPEN-R/MW/OBJS.
  fs::path PlaceOf(const ObjectRecord& record) const {
    // Leaves out the first four characters of the path, "/MS/", because /MS stands for the root of
    // the stick.
    return record.path.size() < 4 ? fs::path() : FindBelow(stick_.root, record.path.substr(4));
  }

  // Returns whether no other stick is nearer to the image's .ocf file.  A stick is near only if its
  // parent folder contains the .ocf file: the deeper this parent folder lies, the nearer is the
  // stick.
  bool IsOfThisStick(const BuiltImage& image) const {
    const auto depth = [&image](const StickFolder& stick) {
      const fs::path around = stick.root.parent_path();
      return IsBelow(image.log.ocf, around) ? std::distance(around.begin(), around.end()) : -1;
    };
    return std::all_of(project_.sticks.begin(), project_.sticks.end(),
                       [&](const StickFolder& other) { return depth(other) <= depth(stick_); });
  }

  void MatchTheRest() {
    UseMatchingImages([this](const BuiltImage& image) { return IsOfThisStick(image); });
    UseMatchingImages([](const BuiltImage&) { return true; });
    for (const std::string& name : missing_) CopyFromKit(name);
  }

  // Finds images of this build for `missing_`, the names in OBJECT.CFG that have no image on the
  // stick yet.  Compares the names (MatchImages()).  Uses only images that are not on the stick yet
  // and for which `is_wanted` returns true.
  void UseMatchingImages(const std::function<bool(const BuiltImage&)>& is_wanted) {
    std::vector<ImageCandidate> candidates;
    std::vector<size_t> indices;
    for (size_t i = 0; i < built_.size(); ++i) {
      if (used_.contains(i) || !is_wanted(built_[i])) continue;
      candidates.push_back({built_[i].names});
      indices.push_back(i);
    }
    const std::vector<int> matches = MatchImages(missing_, candidates);
    std::vector<std::string> rest;
    for (size_t i = 0; i < missing_.size(); ++i) {
      if (matches[i] < 0) {
        rest.push_back(missing_[i]);
      } else {
        UseImage(indices[static_cast<size_t>(matches[i])], missing_[i], "by its name");
      }
    }
    missing_ = rest;
  }

  void UseImage(size_t index, const std::string& name, const char* how) {
    used_.insert(index);
    Copy(built_[index].log.file, name);
    completed_.images.push_back({name, built_[index].log.object, how});
  }

  void Copy(const fs::path& file, const std::string& name) {
    std::error_code error;
    fs::create_directories(objects_, error);
    const fs::path there = FindEntry(objects_, name);
    const fs::path place = there.empty() ? objects_ / name : there;
    const std::string problem = CopyToFile(file, place);
    completed_.placed.push_back(place);
    if (!problem.empty()) completed_.problems.push_back(problem);
  }

  void CopyFromKit(const std::string& name) {
    const fs::path own = FindEntry(fs::path(sdk_root_) / "images", name);
    if (!own.empty()) {
      Copy(own, name);
      completed_.images.push_back({name, "", "the kit's own"});
      return;
    }
    const auto record = *std::find_if(stick_.objects.begin(), stick_.objects.end(),
                                      [&](const ObjectRecord& r) { return FileNameOf(r) == name; });
    const char* why = "no object here has such a name";
    if (has_failures_) why = "an object could not be built, see above";
    if (is_for_robot_[name])
      why = "the file there is for the robot (MIPS), and its sources are not here";
    if (LowerCase(record.path).find("/system/") != std::string::npos)
      why = "it belongs to the robot's own system and has no counterpart here; take the line out";
    completed_.problems.push_back(
        fmt::format("OBJECT.CFG:{}: {} was not built: {}", record.place.line, record.path, why));
  }

  // Puts on this stick all images of this build, except images whose .ocf file is nearer to another
  // stick in the tree of folders (IsOfThisStick()).  Then writes an OBJECT.CFG that names these
  // images and the usable images that already lie in the stick's folder OBJS.  Called when the
  // stick has no OBJECT.CFG, because without this file nothing says which images the stick needs.
  void ListEverything() {
    if (built_.empty()) return;
    ListInstalled();
    for (size_t i = 0; i < built_.size(); ++i) {
      if (used_.contains(i) || !IsOfThisStick(built_[i])) continue;
      const std::string name = ShortImageName(built_[i].log.object);
      UseImage(i, name, "by its name");
      listed_.emplace_back(name, i);
    }
    ListForeign();
    std::string foreign, own;
    for (const auto& [name, index] : listed_)
      (index == kNone ? foreign : own) += fmt::format("/MS/OPEN-R/MW/OBJS/{}\n", name);
    const fs::path folder = objects_.parent_path() / "CONF";
    // Begins OBJECT.CFG with the images that this build has not linked, because one of them may be
    // POWERMON.BIN, which is in the first line of OBJECT.CFG on a robot's stick.
    WriteText(folder / "OBJECT.CFG", foreign + own);
    const bool has_connections = !FindEntry(folder, "CONNECT.CFG").empty();
    if (!has_connections) WriteText(folder / "CONNECT.CFG", "");
    completed_.notes.push_back(
        fmt::format("there is no OBJECT.CFG; one that lists every object was written{}",
                    has_connections ? "" : ", and a CONNECT.CFG without connections"));
    completed_.notes.insert(completed_.notes.end(), unlisted_.begin(), unlisted_.end());
  }

  // Adds to `listed_` (the images that the new OBJECT.CFG names) the images of this build that
  // rules of Makefiles have put on the stick, each under the name that the rule gave it.
  void ListInstalled() {
    for (const fs::path& file : InstalledFiles(stick_)) {
      const size_t index = IndexOf(ReadImageFile(file).bytes);
      if (index == kNone || !IsShortName(file.filename().string())) continue;
      if (!used_.insert(index).second) continue;
      listed_.emplace_back(file.filename(), index);
      completed_.images.push_back({file.filename(), built_[index].log.object, "Makefile"});
    }
  }

  // Adds to `listed_` (the images that the new OBJECT.CFG names) images in the stick's folder OBJS
  // that this build has not linked: the gateway, and images that rules of Makefiles have copied to
  // the stick.  Also adds an image of the user's stick if the SDK tree has an image of the same
  // name, and copies the image of the SDK tree to the stick.  Adds a note about each other image,
  // because it stays out of OBJECT.CFG.
  void ListForeign() {
    std::map<std::string, fs::path> files;  // key: name of the file in upper case
    for (const fs::path& folder :
         {FindBelow(users_stick_, "OPEN-R/MW/OBJS"), stick_.ObjectsFolder()}) {
      for (const fs::path& file : FilesIn(folder)) {
        if (LowerCase(file.extension()) == ".bin") files[UpperCase(file.filename())] = file;
      }
    }
    for (const auto& [name, index] : listed_) files.erase(UpperCase(name));
    for (const auto& [name, file] : files) ListForeign(name, file);
  }

  void ListForeign(const std::string& name, const fs::path& file) {
    const ImageFile image = ReadImageFile(file);
    const bool is_of_make = IsBelow(file, stick_.root);
    const fs::path kits = FindEntry(fs::path(sdk_root_) / "images", name);
    if (!kits.empty() && !(is_of_make && image.problem.empty())) {
      Copy(kits, name);
      completed_.images.push_back({name, "", "the kit's own"});
    } else if (name == kGatewayImage) {
      completed_.images.push_back({name, "", "the runtime's own"});
    } else if (std::string why = ReasonNotListed(name, image, is_of_make); !why.empty()) {
      unlisted_.push_back(fmt::format("OBJS/{} is not in this OBJECT.CFG: {}", name, why));
      return;
    } else {
      completed_.images.push_back({name, "", "Makefile"});
    }
    listed_.emplace_back(name, kNone);
  }

  // Returns the reason why OBJECT.CFG must not list `image`, an image in the stick's folder OBJS
  // that this build has not linked; "" if OBJECT.CFG may list it.  `is_of_make` is true if a rule
  // of a Makefile has copied the image to the stick in this build; false if the image lay on the
  // user's stick before.
  std::string ReasonNotListed(const std::string& name, const ImageFile& image,
                              bool is_of_make) const {
    if (image.is_for_robot) return "it is an image for the robot (MIPS), not for this machine";
    if (!image.problem.empty()) return "it " + image.problem;
    const std::optional<Ocf> ocf = ParseOcf("", OcfTextOf(image.bytes)).ocf;
    for (const auto& [listed, index] : listed_) {
      if (index != kNone && ocf && built_[index].log.object == ocf->name)
        return fmt::format("it is an image of {}, as {} is, which is listed", ocf->name, listed);
    }
    if (!IsShortName(name)) return "its name is not 8.3, so the robot cannot open it";
    if (!is_of_make)
      return "it lay there before this build, and no Makefile puts it there; add its line if the "
             "program needs it";
    return "";
  }

  const StickFolder& stick_;
  const Project& project_;
  const fs::path objects_;
  const std::string sdk_root_;
  const fs::path users_stick_;  // the stick of which `stick_` is a copy; empty if there is none
  const std::vector<BuiltImage> built_;
  const bool has_failures_;
  std::set<size_t> used_;  // indexes in built_ of the images on the stick
  std::vector<std::string> missing_;
  std::map<std::string, bool> is_for_robot_;
  // The images that the new OBJECT.CFG (see ListEverything()) names: the name of each file, and its
  // index in built_, or kNone if this build has not linked the image.
  std::vector<std::pair<std::string, size_t>> listed_;
  std::vector<std::string> unlisted_;  // notes about images that ListEverything() does not list
  CompletedStick completed_;
};

bool HasSameBytes(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (!fs::exists(b, error) || fs::file_size(a, error) != fs::file_size(b, error)) return false;
  return ReadText(a) == ReadText(b);
}

// Returns the path under which to keep the robot's image `image`: `kept`, or a path with a number,
// such as WALK.BIN.2, if there is already another image at `kept`.  So each version of the image
// that a user puts on the stick between two builds is kept.
fs::path PlaceToKeep(const fs::path& image, const fs::path& kept) {
  fs::path place = kept;
  std::error_code error;
  for (int i = 2; fs::exists(place, error) && !HasSameBytes(image, place); ++i)
    place = fmt::format("{}.{}", kept.string(), i);
  return place;
}

// Creates MW/DATA/P, in which programs open files for writing.  OPEN-R does not create missing
// folders, so without this folder programs could not write.
void MakeDataFolder(const StickFolder& stick, const fs::path& target) {
  const fs::path middleware =
      target / stick.ObjectsFolder().parent_path().lexically_relative(stick.root);
  std::error_code error;
  fs::create_directories(WithCaseOnDisk(middleware, "DATA/P"), error);
}

}  // namespace

CompletedStick CompleteStick(const StickFolder& stick, const Project& project, const KitLog& log,
                             const std::string& sdk_root, const fs::path& users_stick) {
  return StickCompletion(stick, project, log, sdk_root, users_stick).Run();
}

void RemoveImages(const std::vector<KitLog::Image>& images, const Project& project) {
  std::error_code error;
  for (const KitLog::Image& image : images) {
    const std::string bytes = ReadImageFile(image.file).bytes;
    for (const StickFolder& stick : project.sticks) {
      for (const fs::path& file : InstalledFiles(stick))
        if (ReadImageFile(file).bytes == bytes) fs::remove(file, error);
    }
    fs::remove(image.file, error);
  }
}

std::vector<std::string> DeliverStick(const StickFolder& stick, const fs::path& target,
                                      const WorkCopy& copy, const fs::path& robot_folder,
                                      bool whole) {
  std::vector<std::string> problems;
  const fs::path openr = FindEntry(stick.root, "OPEN-R");
  if (openr.empty()) return problems;
  for (const fs::path& file : FilesBelow(openr)) {
    const fs::path name = file.lexically_relative(stick.root);
    const fs::path place = target / name;
    if (!whole && copy.IsOriginal(file)) continue;
    if (HasSameBytes(file, place)) continue;
    std::error_code error;
    if (LowerCase(name.extension()) == ".bin" && fs::exists(place, error) &&
        ReadImageFile(place).is_for_robot) {
      const fs::path kept = PlaceToKeep(place, robot_folder / name);
      fs::create_directories(kept.parent_path(), error);
      error = TryCopyFile(place, kept, fs::copy_options::skip_existing);
      if (error) {
        problems.push_back(
            fmt::format("{}: an image for the robot, which stays because it cannot "
                        "be kept as {}: {}",
                        place.string(), kept.string(), error.message()));
        continue;
      }
    }
    fs::create_directories(place.parent_path(), error);
    // Replaces the file on the stick in one step, so that a run never loads an image that is only
    // half copied.
    const fs::path temporary = place.string() + ".tmp";
    error = TryCopyFile(file, temporary, fs::copy_options::overwrite_existing);
    if (!error) fs::rename(temporary, place, error);
    if (error) problems.push_back(fmt::format("{}: {}", place.string(), error.message()));
  }
  MakeDataFolder(stick, target);
  return problems;
}

}  // namespace openr_host
