#include "kit/check_images.h"

#include <OPENR/OPENRServices.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <utility>

#include "kit/image_match.h"
#include "kit/text_files.h"
#include "runtime/base/spelling.h"
#include "runtime/config/gateway_config.h"
#include "runtime/config/line_file.h"
#include "runtime/config/ocf.h"
#include "runtime/core/image_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Services of OVirtualRobotComm and OVirtualRobotAudioComm, system objects of the robot.
// CONNECT.CFG may name these services although no image on the stick has them.
const char* const kRobotServices[] = {ovrcommSENSOR, ovrcommEFFECTOR, ovrcommFBK,
                                      ovrcommMIC,    ovrcommSPEAKER,  ovrcommALERT};

// Returns the name of the object in the .ocf text that a host image contains; "" if the image has
// no such text.
std::string ObjectNameIn(std::string_view bytes) {
  for (const std::string_view text : TextsIn(bytes)) {
    if (text.find("object") == std::string_view::npos) continue;
    const OcfResult ocf = ParseOcf("", text);
    if (ocf.ocf) return ocf.ocf->name;
  }
  return "";
}

// A line of OBJECT.CFG without an image that the host can load: the file is missing, or is an image
// for the robot.
struct MissingImage {
  ObjectRecord record;
  // Reason why the host cannot load the robot's image that is on the stick; "": the stick has no
  // file of this name.
  std::string problem;
};

class ImageCheck {
 public:
  ImageCheck(const StickFolder& stick, const Project& project, const ObjectParts& parts,
             CheckTarget target, Remarks* remarks)
      : stick_(stick), parts_(parts), target_(target), remarks_(remarks) {
    for (const auto* objects : {&project.objects, &project.neighbours}) {
      for (const ObjectFolder& object : *objects) objects_.push_back(&object);
    }
    has_sources_ = !objects_.empty() || !project.makefiles.empty();
    for (const char* service : kRobotServices)
      images_.services.insert({service, {"the robot", ""}});
  }

  StickImages Run() {
    if (stick_.object_config.empty()) {
      remarks_->Error((stick_.root / "OPEN-R/MW/CONF/OBJECT.CFG").string(),
                      "is missing; it lists the images to load, one path a line");
      return std::move(images_);
    }
    const std::string text = ReadText(stick_.object_config).value_or("");
    const ObjectConfig config = ParseObjectConfig(stick_.object_config, text, kEveryDesign);
    remarks_->AddAll(config.diagnostics);
    bool has_power_monitor = false;
    for (const ObjectRecord& record : config.objects) {
      has_power_monitor =
          has_power_monitor || EqualsIgnoringCase(FileNameOf(record), "POWERMON.BIN");
      CheckRecord(record);
    }
    ExpectFromProject();
    CheckPlacedNames();
    if (!has_power_monitor && !config.objects.empty()) {
      remarks_->Note(stick_.object_config,
                     "no POWERMON.BIN: nothing handles the pause button and an empty battery");
    }
    return std::move(images_);
  }

 private:
  void CheckRecord(const ObjectRecord& record);
  void CheckImage(const ObjectRecord& record, const fs::path& file, const ImageFile& image);
  bool HasOcfName(const ObjectFolder& object, const std::string& name) const;
  bool HasServicesIn(const ObjectFolder& object, const ObjectRecord& record) const;
  void ExpectFromProject();
  void ReportMissing(const MissingImage& image, bool may_be_made);
  std::vector<int> MatchMissing() const;
  std::vector<std::string> NamesOf(const ObjectFolder& object) const;
  void Place(const ObjectFolder& object, const std::string& section);
  void AddServices(const ObjectFolder& object, const std::string& section);
  bool IsPlaced(const ObjectFolder& object) const;
  void CheckPlacedNames();

  const StickFolder& stick_;
  const ObjectParts& parts_;
  const CheckTarget target_;
  Remarks* const remarks_;
  std::vector<const ObjectFolder*> objects_;  // Project::objects, then Project::neighbours
  bool has_sources_ = false;
  StickImages images_;
  std::vector<PlacedObject> placed_;
  std::vector<MissingImage> missing_;
  // Lines of OBJECT.CFG; the key is the name of the object in the image that a line names.  Two
  // images whose objects have the same name are an error if one robot loads both.
  std::map<std::string, std::vector<ObjectRecord>> lines_by_name_;
};

void ImageCheck::CheckRecord(const ObjectRecord& record) {
  if (std::any_of(record.path.begin(), record.path.end(),
                  [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; })) {
    remarks_->AddConsequence(Remark::Kind::kNote, record.place, "lower case",
                             "lower case in a path; the stick keeps names in upper case");
  }
  // Skips the line of the gateway's image, because the gateway is a part of the robot's system.
  if (EqualsIgnoringCase(FileNameOf(record), kGatewayImage)) {
    images_.has_gateway = true;
    return;
  }
  const fs::path file =
      record.path.size() < 4 ? fs::path() : FindBelow(stick_.root, record.path.substr(4));
  if (file.empty()) {
    missing_.push_back({record, ""});
    return;
  }
  const ImageFile image = ReadImageFile(file);
  // Treats an image for the robot as missing if there are sources to build, because a build will
  // replace that image by an image for the host.
  if (image.is_for_robot && has_sources_) {
    missing_.push_back({record, image.problem});
  } else if (!image.problem.empty() && !(image.is_for_robot && target_ == CheckTarget::kRobot)) {
    remarks_->Add(Remark::Kind::kError, record.place,
                  fmt::format("{} {}", record.path, image.problem));
  }
  CheckImage(record, file, image);
}

void ImageCheck::CheckImage(const ObjectRecord& record, const fs::path& file,
                            const ImageFile& image) {
  for (const std::string& name : ServicesInImage(image.bytes))
    images_.services.insert({name, {FileNameOf(record), record.section}});
  const std::string name = image.bytes.empty() ? "" : ObjectNameIn(image.bytes);
  if (name.empty()) return;
  for (const ObjectRecord& other : lines_by_name_[name]) {
    const bool is_same = EqualsIgnoringCase(FileNameOf(other), FileNameOf(record));
    if (is_same || !MayBothApply(other.section, record.section)) continue;
    remarks_->Add(Remark::Kind::kError, record.place,
                  fmt::format("its object is named '{}' like that of {}; names in .ocf files must "
                              "differ",
                              name, FileNameOf(other)));
  }
  lines_by_name_[name].push_back(record);
  if (!image.problem.empty()) return;
  std::vector<const ObjectFolder*> namesakes;
  for (const ObjectFolder* object : objects_) {
    if (HasOcfName(*object, name)) namesakes.push_back(object);
  }
  // Finds the object from which the image was built.  Objects for different robots often share a
  // name.  So if several objects have the name in the image, drops each object with a service that
  // the image lacks.  Does not compare the services of a single object, because its stub.cfg may
  // have changed since the image was built.
  if (namesakes.size() > 1)
    std::erase_if(namesakes,
                  [&](const ObjectFolder* object) { return !HasServicesIn(*object, record); });
  for (const ObjectFolder* object : namesakes) Place(*object, record.section);
  if (namesakes.size() != 1) return;
  // Adds an image only once to the built images, even if several sections of OBJECT.CFG, for
  // different robots, list it.
  const bool is_known = std::any_of(
      images_.built.begin(), images_.built.end(),
      [&](const auto& built) { return built.folder == namesakes.front() && built.image == file; });
  if (!is_known) images_.built.push_back({namesakes.front(), file});
}

bool ImageCheck::HasOcfName(const ObjectFolder& object, const std::string& name) const {
  const std::vector<fs::path> files = parts_.OcfsOf(object);
  return std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
    const OcfResult ocf = ParseOcf("", ReadText(file).value_or(""));
    return ocf.ocf && ocf.ocf->name == name;
  });
}

// Returns whether the image of `record`, a line of OBJECT.CFG, has all services that the stub.cfg
// of `object` declares.
bool ImageCheck::HasServicesIn(const ObjectFolder& object, const ObjectRecord& record) const {
  if (object.stub.empty()) return true;
  const StubConfig stub = ParseStubConfig(object.stub, ReadText(object.stub).value_or("")).config;
  const auto is_there = [&](const StubService& service) {
    const auto [begin, end] = images_.services.equal_range(Compose(service.name));
    return std::any_of(begin, end, [&](const auto& entry) {
      return entry.second.name == FileNameOf(record) && entry.second.section == record.section;
    });
  };
  return std::all_of(stub.subjects.begin(), stub.subjects.end(), is_there) &&
         std::all_of(stub.observers.begin(), stub.observers.end(), is_there);
}

std::vector<std::string> ImageCheck::NamesOf(const ObjectFolder& object) const {
  std::vector<std::string> names = parts_.ImageNamesOf(object);
  names.push_back(object.folder.filename().string() + ".");
  names.push_back(object.class_name + ".");
  for (const fs::path& file : parts_.OcfsOf(object)) {
    names.push_back(file.filename());
    const OcfResult ocf = ParseOcf("", ReadText(file).value_or(""));
    if (ocf.ocf) names.push_back(ocf.ocf->name + ".");
  }
  return names;
}

// Finds the objects from which a build will make the images in `missing_`.  OBJECT.CFG names these
// images, and the stick lacks them or has them only for the robot's processor.  Returns for each
// image the index of its object in `objects_`; -1 if no object has a similar name.  Lines for
// different robots may name the same image, so each file name is matched only once.
std::vector<int> ImageCheck::MatchMissing() const {
  std::vector<std::string> wanted;
  std::vector<size_t> index_of;
  for (const MissingImage& image : missing_) {
    const std::string name = FileNameOf(image.record);
    const auto known = std::find_if(wanted.begin(), wanted.end(), [&](const std::string& other) {
      return EqualsIgnoringCase(other, name);
    });
    index_of.push_back(static_cast<size_t>(known - wanted.begin()));
    if (known == wanted.end()) wanted.push_back(name);
  }
  std::vector<ImageCandidate> candidates;
  std::vector<int> object_of;
  for (size_t i = 0; i < objects_.size(); ++i) {
    if (IsPlaced(*objects_[i])) continue;
    candidates.push_back({NamesOf(*objects_[i])});
    object_of.push_back(static_cast<int>(i));
  }
  const std::vector<int> matches = MatchImages(wanted, candidates);
  std::vector<int> objects;
  for (const size_t index : index_of)
    objects.push_back(matches[index] < 0 ? -1 : object_of[static_cast<size_t>(matches[index])]);
  return objects;
}

// Finds the objects of the project from which a build will make the missing images, and reports the
// images that no build will make.
void ImageCheck::ExpectFromProject() {
  const std::vector<int> matches = MatchMissing();
  std::vector<const MissingImage*> rest;
  for (size_t i = 0; i < missing_.size(); ++i) {
    const ObjectRecord& record = missing_[i].record;
    if (matches[i] < 0) {
      rest.push_back(&missing_[i]);
      continue;
    }
    const ObjectFolder& object = *objects_[static_cast<size_t>(matches[i])];
    remarks_->Add(Remark::Kind::kNote, record.place,
                  fmt::format("not built yet; 'openr build' makes it of {}",
                              object.folder.filename().string()));
    Place(object, record.section);
  }
  std::vector<const ObjectFolder*> free;
  for (const ObjectFolder* object : objects_) {
    if (!IsPlaced(*object)) free.push_back(object);
  }
  bool is_some_made = false;
  for (const MissingImage* image : rest) {
    const bool is_named = parts_.MakefilesName(FileNameOf(image->record));
    const bool is_made = is_named || (parts_.HasUnreadableInstall() && !free.empty());
    ReportMissing(*image, is_made);
    is_some_made = is_some_made || is_made;
  }
  // Adds the services of all objects without a known image (`free`) if a rule of a Makefile makes a
  // missing image.  The image may belong to any of these objects, so connections to their services
  // must get no error.
  for (size_t i = 0; is_some_made && i < free.size(); ++i) AddServices(*free[i], "");
}

void ImageCheck::ReportMissing(const MissingImage& image, bool may_be_made) {
  const ObjectRecord& record = image.record;
  if (has_sources_ && EqualsIgnoringCase(FileNameOf(record), "POWERMON.BIN")) {
    remarks_->Add(Remark::Kind::kNote, record.place,
                  "not built here; 'openr build' puts the kit's own there");
    return;
  }
  if (may_be_made) {
    remarks_->Add(Remark::Kind::kNote, record.place,
                  "not built yet; a rule of a Makefile makes it, 'openr build' runs it");
    return;
  }
  images_.knows_all = false;
  if (!image.problem.empty()) {
    remarks_->Add(Remark::Kind::kError, record.place,
                  fmt::format("{} {}", record.path, image.problem));
    return;
  }
  std::vector<std::string> there = parts_.AllImageNames();
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(stick_.ObjectsFolder(), error))
    there.push_back(entry.path().filename());
  std::sort(there.begin(), there.end());
  remarks_->Add(Remark::Kind::kError, record.place,
                fmt::format("{} does not exist on the stick; the robot stops with error 90{}",
                            record.path, DidYouMean(FileNameOf(record), there)));
}

bool ImageCheck::IsPlaced(const ObjectFolder& object) const {
  return std::any_of(placed_.begin(), placed_.end(),
                     [&](const PlacedObject& placed) { return placed.folder == &object; });
}

void ImageCheck::Place(const ObjectFolder& object, const std::string& section) {
  placed_.push_back({&object, section});
  AddServices(object, section);
}

void ImageCheck::AddServices(const ObjectFolder& object, const std::string& section) {
  const std::string owner = object.folder.filename();
  if (!object.stub.empty()) {
    const StubConfig stub = ParseStubConfig(object.stub, ReadText(object.stub).value_or("")).config;
    for (const auto* side : {&stub.subjects, &stub.observers}) {
      for (const StubService& service : *side) {
        images_.services.insert({Compose(service.name), {owner, section}});
        images_.declared.push_back(service);
      }
    }
    return;
  }
  // Searches the sources of an object without stub.cfg for strings that look like names of
  // services.  The length of each word is limited, because std::regex_search() calls itself for
  // each character that a repetition matches, so a long string could overflow the stack.
  static const std::regex kService("\"(\\w{1,100}\\.\\w{1,100}\\.\\w{1,100}\\.[SO])\"");
  for (const fs::path& file : parts_.CodeOf(object)) {
    const std::string& text = parts_.TextOf(file);
    for (std::sregex_iterator it(text.begin(), text.end(), kService), end; it != end; ++it)
      images_.services.insert({(*it)[1].str(), {owner, section}});
  }
}

void ImageCheck::CheckPlacedNames() {
  // Puts the objects that OBJECT.CFG loads into the order of their folders in `objects_`, so that
  // the order of the remarks does not depend on the order of lines in OBJECT.CFG.
  std::vector<PlacedObject> in_order;
  for (const ObjectFolder* object : objects_) {
    for (const PlacedObject& placed : placed_) {
      if (placed.folder == object) in_order.push_back(placed);
    }
  }
  CheckObjectNames(in_order, parts_, remarks_);
}

}  // namespace

StickImages CheckImages(const StickFolder& stick, const Project& project, const ObjectParts& parts,
                        CheckTarget target, Remarks* remarks) {
  return ImageCheck(stick, project, parts, target, remarks).Run();
}

}  // namespace openr_host
