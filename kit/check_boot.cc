#include "kit/check_boot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

#include "kit/text_files.h"
#include "runtime/base/spelling.h"
#include "runtime/config/line_file.h"
#include "runtime/config/object_config.h"
#include "runtime/config/wlan_config.h"
#include "runtime/core/image_file.h"
#include "runtime/stick/gzip.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Files of the base image, the part of a stick that is Sony's and comes with the SDK (measured.md
// 4, "Base tree").
constexpr const char* kBaseFiles[] = {"OPEN-R/APERIOS.GZ",
                                      "OPEN-R/APERINIT.GZ",
                                      "OPEN-R/BOOTPARA",
                                      "OPEN-R/SYSTEM/VERSION",
                                      "OPEN-R/SYSTEM/CONF/OBJECT.CFG",
                                      "OPEN-R/SYSTEM/CONF/EXTOBJ.CFG",
                                      "OPEN-R/SYSTEM/CONF/EMON.CFG",
                                      "OPEN-R/MW/CONF/DESIGN.CFG"};
constexpr const char* kSystemObjects[] = {"POWERMGR", "SRVCMGR", "VR",       "DR",
                                          "SYSLOG",   "VRCOMM",  "VRAUCOMM", "EMGCYMON"};
constexpr const char* kNetworkObjects[] = {"IPSTACK", "WLANDRV", "WLANENBL", "NETCONFS"};
constexpr const char* kConsoleObjects[] = {"ANTTCPIO", "HOOK", "HOOKACT"};

// Objects that take files over the network: Sony's TinyFTPD, and our RCServer.
constexpr const char* kUploadObjects[] = {"TINYFTPD.BIN", "RCSERVER.BIN"};

// A robot has 32 MiB of memory; an image that is larger cannot be loaded.
constexpr uint64_t kRobotMemory = 32u << 20;

// Returns the names of the image files that the stick in the folder `root` lacks in
// OPEN-R/SYSTEM/OBJS.  `objects` has the names of all wanted images, without ".BIN".
template <size_t N>
std::vector<std::string> MissingObjects(const fs::path& root, const char* const (&objects)[N]) {
  std::vector<std::string> missing;
  for (const std::string name : objects)
    if (FindBelow(root, "OPEN-R/SYSTEM/OBJS/" + name + ".BIN").empty())
      missing.push_back(name + ".BIN");
  return missing;
}

// Returns the files of the base image, without its objects, that the stick in `root` lacks.
std::vector<std::string> MissingBaseFiles(const fs::path& root) {
  std::vector<std::string> missing;
  for (const std::string file : kBaseFiles)
    if (FindBelow(root, file).empty()) missing.push_back(file);
  return missing;
}

// Returns whether the text of DESIGN.CFG names `design`.  Does not take the beginning of "ERS-7M2"
// for the name "ERS-7".  "ERS-7M2" itself names no design, because an ERS-7M2 calls itself ERS-7
// (field-notes.md 5.3).
bool NamesDesign(const std::string& text, const std::string& design) {
  for (size_t at = text.find(design); at != std::string::npos; at = text.find(design, at + 1)) {
    if (text.compare(at + design.size(), 2, "M2") != 0) return true;
  }
  return false;
}

// Returns the flag of gzip, such as "-9", with which the image file was compressed; "" if the file
// does not tell the flag.  Byte 8 of a gzip file is 2 for the best compression and 4 for the
// fastest (RFC 1952, 2.3.1).  For all flags between them, such as -6, this byte is 0.
std::string GzipFlagOf(const fs::path& file) {
  const std::string bytes = ReadText(file).value_or("");
  if (!IsGzip(bytes) || bytes.size() < 10) return "";
  return bytes[8] == 2 ? "-9" : bytes[8] == 4 ? "-1" : "";
}

class BootCheck {
 public:
  BootCheck(const std::string& root, std::string design, Remarks* remarks)
      : root_(root), design_(std::move(design)), remarks_(remarks) {}

  StickSummary Run() {
    Measure();
    CheckBase();
    CheckDesign();
    CheckImages();
    CheckNetwork();
    CheckUploads();
    CheckWriteProtection();
    return summary_;
  }

 private:
  fs::path On(const std::string& path) const { return FindBelow(root_, path); }
  std::string Shown(const std::string& path) const {
    const fs::path found = On(path);
    return (found.empty() ? root_ / path : found).string();
  }

  void Measure();
  void CheckBase();
  void CheckDesign();
  void CheckImages();
  void CheckImage(const ObjectRecord& record, const fs::path& file);
  void CheckNetwork();
  void CheckUploads();
  void CheckWriteProtection();

  const fs::path root_;
  const std::string design_;
  Remarks* const remarks_;
  StickSummary summary_;
  bool needs_network_ = false;
};

void BootCheck::Measure() {
  std::error_code error;
  for (const fs::path& file : FilesBelow(FindEntry(root_, "OPEN-R"))) {
    if (!fs::is_regular_file(file, error)) continue;
    ++summary_.num_files;
    summary_.num_bytes += fs::file_size(file, error);
  }
}

void BootCheck::CheckBase() {
  if (!HasBaseImage(root_)) {
    remarks_->Error(root_.string(),
                    "has no base image, so a robot does not boot from it: copy OPEN-R of the SDK's "
                    "OPEN_R/MS_ERS200 (ERS-7: MS_ERS7) here first, WCONSOLE/memprot for network "
                    "and console; 'openr stick new --base DIR' and 'openr stick robot' do so");
    return;
  }
  for (const std::string& file : MissingBaseFiles(root_))
    remarks_->Error(Shown(file),
                    "is missing; it belongs to the base image of the SDK, which must "
                    "be copied whole");
  const std::vector<std::string> objects = MissingObjects(root_, kSystemObjects);
  if (!objects.empty()) {
    remarks_->Error(Shown("OPEN-R/SYSTEM/OBJS"),
                    fmt::format("lacks {} of the base image, which must be copied whole",
                                fmt::join(objects, ", ")));
  }
  // Recognises the kind of the base image by the system objects that it lacks: BASIC has no objects
  // for the network, WLAN has none for the console, and WCONSOLE has both.
  summary_.base = !MissingObjects(root_, kNetworkObjects).empty()   ? "BASIC"
                  : !MissingObjects(root_, kConsoleObjects).empty() ? "WLAN"
                                                                    : "WCONSOLE";
  if (summary_.base == "WCONSOLE") {
    remarks_->Note(root_.string(),
                   "has the base image with a console: the robot may seem dead until somebody "
                   "connects to its port 59000 (field-notes.md 5)");
  }
}

// Checks that DESIGN.CFG names the design of the robot.  If it names another design, the robot ends
// its boot with "DR OPEN-R SDK version can run odrexecMODE3 only" (field-notes.md 5).
void BootCheck::CheckDesign() {
  const fs::path file = On("OPEN-R/MW/CONF/DESIGN.CFG");
  if (file.empty() || design_.empty()) return;
  if (!NamesDesign(ReadText(file).value_or(""), design_)) {
    remarks_->Error(file.string(),
                    fmt::format("does not name {}: its boot would end with 'can run odrexecMODE3 "
                                "only'; take the DESIGN.CFG of the base image for this robot",
                                design_));
  }
}

void BootCheck::CheckImages() {
  const fs::path file = On("OPEN-R/MW/CONF/OBJECT.CFG");
  if (file.empty()) return;
  const ObjectConfig config = ParseObjectConfig(file, ReadText(file).value_or(""), kEveryDesign);
  if (config.objects.empty())
    remarks_->Warning(file.string(), "names no object; the robot boots and does nothing");
  std::set<fs::path> images;  // each image once, because records of several designs may name it
  for (const ObjectRecord& record : config.objects) {
    const fs::path image = record.path.size() < 4 ? fs::path() : On(record.path.substr(4));
    if (image.empty()) continue;
    CheckImage(record, image);
    images.insert(image);
  }
  std::error_code error;
  for (const fs::path& image : images) {
    if (!fs::is_regular_file(image, error)) continue;
    ++summary_.num_images;
    summary_.image_bytes += fs::file_size(image, error);
  }
}

void BootCheck::CheckImage(const ObjectRecord& record, const fs::path& file) {
  const ImageFile image = ReadImageFile(file);
  // Searches the strings of the image for names of the robot's network stack (IPStack, antStack),
  // because an object that uses the network contains such a name.
  for (const std::string_view text : TextsIn(image.bytes))
    needs_network_ = needs_network_ || text.find("antStack") != std::string_view::npos ||
                     text.find("IPStack") != std::string_view::npos;
  if (!image.is_for_robot) {
    remarks_->Add(
        Remark::Kind::kError, record.place,
        fmt::format("{} is not for the robot's processor{}; 'openr stick robot', or make "
                    "with the robot's SDK, builds it",
                    record.path, image.problem.empty() ? ": it is an image of a host" : ""));
  } else if (!image.is_compressed) {
    remarks_->Add(Remark::Kind::kNote, record.place,
                  fmt::format("{} is not compressed; all images of the SDK's samples are (gzip -6)",
                              record.path));
  } else if (const std::string flag = GzipFlagOf(file); !flag.empty()) {
    remarks_->Add(
        Remark::Kind::kNote, record.place,
        fmt::format("{} is compressed as by gzip {}; a robot could not read images of "
                    "some flags, which ones is not known, and gzip -6 is known to be good "
                    "(field-notes.md 5.8)",
                    record.path, flag));
  }
  if (image.bytes.size() > kRobotMemory) {
    remarks_->Add(Remark::Kind::kError, record.place,
                  fmt::format("{} has {} bytes unpacked, and a robot has 32 MiB of memory",
                              record.path, image.bytes.size()));
  }
}

void BootCheck::CheckNetwork() {
  const bool has_settings = !On("OPEN-R/SYSTEM/CONF/WLANCONF.TXT").empty();
  if (summary_.base.empty()) return;
  if (summary_.base == "BASIC") {
    if (needs_network_)
      remarks_->Warning(root_.string(),
                        "has the base image BASIC, which has no network, and an "
                        "object that uses IPStack; take WLAN or WCONSOLE");
    return;
  }
  if (!has_settings) {
    remarks_->Warning(Shown("OPEN-R/SYSTEM/CONF/WLANCONF.TXT"),
                      "is missing: the robot takes WLANDFLT.TXT of the base image (10.0.1.100 in "
                      "the network AIBONET); 'openr stick wlan' writes one");
    return;
  }
  const fs::path file = On("OPEN-R/SYSTEM/CONF/WLANCONF.TXT");
  const WlanConfig config = ParseWlanConfig(file, ReadText(file).value_or("")).config;
  const char* const newer = config.use_dhcp                    ? "USE_DHCP=1"
                            : config.wep_key.starts_with("0x") ? "a WEPKEY in hexadecimal digits"
                                                               : nullptr;
  if (newer != nullptr) {
    remarks_->Note(file.string(),
                   fmt::format("has {}, which needs a base image of the SDK 1.1.4 or later; older "
                               "ones do not know it (field-notes.md 5.7)",
                               newer));
  }
}

// Adds a note if the base image has a network, but OBJECT.CFG names none of the known objects that
// receive files over the network.  Then the user must take the stick out of the robot for each
// change of a file.
void BootCheck::CheckUploads() {
  if (summary_.base.empty() || summary_.base == "BASIC") return;
  const fs::path file = On("OPEN-R/MW/CONF/OBJECT.CFG");
  if (file.empty()) return;
  const ObjectConfig config = ParseObjectConfig(file, ReadText(file).value_or(""), kEveryDesign);
  for (const ObjectRecord& record : config.objects) {
    for (const char* name : kUploadObjects) {
      if (EqualsIgnoringCase(fs::path(record.path).filename().string(), name)) return;
    }
  }
  remarks_->Note(file.string(),
                 "names neither TINYFTPD.BIN nor RCSERVER.BIN: no object that is known takes files "
                 "over the network, so the stick has to be taken out for each change");
}

// Adds a note about write-protected configuration files.  No program of the robot can replace such
// a file, and TinyFTPD answers 553 when somebody uploads such a file by FTP (field-notes.md 5.10).
void BootCheck::CheckWriteProtection() {
  constexpr auto kAnyWrite =
      fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  for (const char* folder : {"OPEN-R/MW/CONF", "OPEN-R/SYSTEM/CONF"}) {
    if (On(folder).empty()) continue;
    std::vector<std::string> names;
    for (const fs::path& file : FilesBelow(On(folder))) {
      std::error_code error;
      const fs::file_status status = fs::status(file, error);
      if (fs::is_regular_file(status) && (status.permissions() & kAnyWrite) == fs::perms::none)
        names.push_back(file.filename());
    }
    if (names.empty()) continue;
    remarks_->Note(
        Shown(folder),
        fmt::format("has write-protected files: {}; nobody can replace them over the "
                    "network, TinyFTPD answers 553 (field-notes.md 5.10); chmod u+w lifts "
                    "the protection",
                    fmt::join(names, ", ")));
  }
}

}  // namespace

bool HasBaseImage(const std::string& root) {
  return MissingBaseFiles(root).size() < std::size(kBaseFiles) ||
         MissingObjects(root, kSystemObjects).size() < std::size(kSystemObjects);
}

std::string BaseImageContents() {
  return fmt::format(
      "a base image has {}, and {}.BIN in OPEN-R/SYSTEM/OBJS; those of the SDK are in "
      "OPEN_R/MS_ERS200 (ERS-7: MS_ERS7), such as WCONSOLE/memprot",
      fmt::join(kBaseFiles, ", "), fmt::join(kSystemObjects, ".BIN, "));
}

StickSummary CheckBoot(const std::string& root, const std::string& design, Remarks* remarks) {
  return BootCheck(root, design, remarks).Run();
}

}  // namespace openr_host
