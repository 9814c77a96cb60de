#include "kit/check_stick.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "kit/check_images.h"
#include "kit/check_layouts.h"
#include "kit/check_objects.h"
#include "kit/text_files.h"
#include "kit/wlan_file.h"
#include "runtime/base/spelling.h"
#include "runtime/config/address_config.h"
#include "runtime/config/connect_config.h"
#include "runtime/config/design_config.h"
#include "runtime/config/gateway_config.h"
#include "runtime/config/line_file.h"
#include "runtime/config/wlan_config.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// The robot's address in the samples of Sony's SDK.  A robot that openr runs on this computer has
// the address 127.0.0.1, so each line of a configuration file with the samples' address gets a
// note.
constexpr char kSampleRobotAddress[] = "10.0.1.100";

// ERS-7M2 is the name of a product and not of a design: an ERS-7M2 calls itself ERS-7.  So no robot
// reads a section with the name ERS-7M2.
constexpr char kNoDesign[] = "ERS-7M2";

constexpr char kWlanFile[] = "WLANCONF.TXT";
// A file name counts as a misspelling of WLANCONF.TXT up to this edit distance.  The limit is below
// 4, the distance of WLANDFLT.TXT, which is the name of another valid file.
constexpr int kMisspeltDistanceMax = 3;

class StickCheck {
 public:
  StickCheck(const StickFolder& stick, const Project& project, const ObjectParts& parts,
             CheckTarget target, Remarks* remarks)
      : stick_(stick),
        parts_(parts),
        remarks_(remarks),
        images_(CheckImages(stick, project, parts, target, remarks)) {}

  void Run() {
    CheckConnections();
    CheckGateway();
    CheckDesigns();
    CheckSections();
    CheckWlan();
    CheckFileNames();
  }

 private:
  fs::path Config(const char* name) const {
    return FindBelow(stick_.root, fmt::format("OPEN-R/MW/CONF/{}", name));
  }
  fs::path OnStick(const std::string& path) const {
    return path.size() < 4 ? fs::path() : FindBelow(stick_.root, path.substr(4));
  }

  void CheckConnections();
  void CheckService(const ServiceName& name, const std::string& section, const FilePosition& place);
  void ReportUnknown(const ServiceName& name, const FilePosition& place);
  void CheckUnconnected(const std::set<std::string>& connected);
  void CheckGateway();
  void NoteOldAddresses(const GatewayConfig& host);
  GatewayConfig ReadGateway(const fs::path& file, GatewaySide side);
  void CheckDesigns();
  void CheckSection(const std::string& section, const FilePosition& place);
  void CheckSections();
  void CheckWlan();
  void CheckFileNames();

  const StickFolder& stick_;
  const ObjectParts& parts_;
  Remarks* const remarks_;
  const StickImages images_;
  ConnectConfig wires_;
};

// Checks that an object on the stick has the service `name`, which a line of CONNECT.CFG names at
// `place`.  `section` is the section that contains this line.  Each section is for one design of
// robot; "" means that the line is for all robots.
void StickCheck::CheckService(const ServiceName& name, const std::string& section,
                              const FilePosition& place) {
  const std::string full = Compose(name);
  if (full.starts_with(kGatewayPrefix)) return;
  const auto [begin, end] = images_.services.equal_range(full);
  if (begin == end) return ReportUnknown(name, place);
  const bool is_there = std::any_of(
      begin, end, [&](const auto& entry) { return MayBothApply(entry.second.section, section); });
  if (is_there) return;
  const ServiceOwner& owner = begin->second;
  remarks_->Add(Remark::Kind::kWarning, place,
                fmt::format("OBJECT.CFG loads {} for [{}] only, and this line holds for [{}]: "
                            "'{}' is NOT FOUND there, the line is skipped",
                            owner.name, owner.section, section, full));
}

void StickCheck::ReportUnknown(const ServiceName& name, const FilePosition& place) {
  const std::string full = Compose(name);
  // Gives the remarks about all services of a missing object the same cause, so that they become
  // one remark.  If the object exists and only a service is missing, the cause is that service.
  std::string cause = name.object + ".";
  std::vector<std::string> known;
  for (const auto& [service, owner] : images_.services) {
    known.push_back(service);
    if (service.starts_with(name.object + ".")) cause = full;
    const auto other = ParseServiceName(service, nullptr);
    if (!other || !DifferInDataOnly(*other, name)) continue;
    remarks_->Add(Remark::Kind::kError, place,
                  fmt::format("'{}' has the data type '{}' in {}, not '{}'; the line is skipped",
                              full, other->data, owner.name, name.data));
    return;
  }
  remarks_->AddConsequence(
      images_.knows_all ? Remark::Kind::kError : Remark::Kind::kWarning, place,
      "NOT FOUND " + cause,
      fmt::format("no object on this stick has '{}': NOT FOUND, the line is skipped{}", full,
                  DidYouMean(full, known)));
}

void StickCheck::CheckConnections() {
  const fs::path file = Config("CONNECT.CFG");
  if (file.empty()) {
    remarks_->Note((stick_.root / "OPEN-R/MW/CONF/CONNECT.CFG").string(),
                   "is missing: no object is connected");
    return;
  }
  wires_ = ParseConnectConfig(file, ReadText(file).value_or(""), kEveryDesign);
  remarks_->AddAll(wires_.diagnostics);
  std::set<std::string> connected;
  for (const ConnectRecord& record : wires_.connections) {
    CheckService(record.subject, record.section, record.subject_place);
    CheckService(record.observer, record.section, record.observer_place);
    connected.insert(Compose(record.subject));
    connected.insert(Compose(record.observer));
  }
  CheckUnconnected(connected);
  CheckLayouts(wires_, images_, parts_, remarks_);
}

void StickCheck::CheckUnconnected(const std::set<std::string>& connected) {
  for (const StubService& service : images_.declared) {
    if (IsDummy(service) || connected.contains(Compose(service.name))) continue;
    if (service.connect_function.empty() && service.data_function.empty()) continue;
    remarks_->AddConsequence(
        Remark::Kind::kNote, service.place, "not connected",
        fmt::format("CONNECT.CFG does not mention '{}'; if that is meant, call its data "
                    "DoNotConnect",
                    Compose(service.name)));
  }
}

GatewayConfig StickCheck::ReadGateway(const fs::path& file, GatewaySide side) {
  if (file.empty()) return {};
  GatewayConfig config = ParseGatewayConfig(file, ReadText(file).value_or(""), kEveryDesign, side);
  remarks_->AddAll(config.diagnostics);
  return config;
}

// Checks the gateway, which carries services between objects and programs on other machines over
// TCP: its configuration files, and the lines of CONNECT.CFG that connect objects to it.
void StickCheck::CheckGateway() {
  const fs::path robot_file = Config(kRobotGatewayFile), host_file = Config(kHostGatewayFile);
  GatewayConfig config = ReadGateway(robot_file, GatewaySide::kRobot);
  const GatewayConfig host = ReadGateway(host_file, GatewaySide::kHost);
  config.services.insert(config.services.end(), host.services.begin(), host.services.end());
  NoteOldAddresses(host);
  for (const auto& proxy : {config.proxy, host.proxy}) {
    if (!proxy) continue;
    remarks_->Add(Remark::Kind::kNote, proxy->place,
                  "of the OPEN-R calls of a program on a PC, those that make joints move are "
                  "carried; docs/network.md lists them, and which are not known");
  }
  remarks_->AddAll(CheckGatewayWires(wires_, config, kRobotGatewayFile));
  for (const GatewayRecord& record : config.services) {
    const bool is_wired = std::any_of(
        wires_.connections.begin(), wires_.connections.end(), [&](const ConnectRecord& wire) {
          return wire.subject == record.service || wire.observer == record.service;
        });
    if (!is_wired) {
      remarks_->Add(Remark::Kind::kNote, record.place,
                    "CONNECT.CFG does not mention this service; nothing goes through its port");
    }
  }
  if (!robot_file.empty() && !images_.has_gateway) {
    remarks_->Warning(stick_.object_config,
                      fmt::format("does not name /MS/OPEN-R/SYSTEM/OBJS/{}; {} has no effect on "
                                  "the robot then",
                                  kGatewayImage, kRobotGatewayFile));
  }
  if (robot_file.empty() && images_.has_gateway) {
    remarks_->Warning(stick_.object_config,
                      fmt::format("names {}, but there is no {} beside it: the gateway has no "
                                  "services",
                                  kGatewayImage, kRobotGatewayFile));
  }
}

// Adds a note for each line with the address that a real robot had in Sony's samples, because a
// robot that openr runs on this computer has another address.
void StickCheck::NoteOldAddresses(const GatewayConfig& host) {
  const fs::path file = Config(kAddressFile);
  AddressConfig addresses;
  if (!file.empty())
    addresses = ParseAddressConfig(file, ReadText(file).value_or(""), kEveryDesign);
  remarks_->AddAll(addresses.diagnostics);
  std::vector<GatewayRecord> records = host.services;
  if (host.proxy) records.push_back(*host.proxy);
  for (const GatewayRecord& record : records) {
    const bool is_mapped = std::any_of(
        addresses.pairs.begin(), addresses.pairs.end(),
        [&](const AddressPair& pair) { return AddressText(pair.robot) == record.host; });
    if (record.host != kSampleRobotAddress || is_mapped) continue;
    remarks_->Add(Remark::Kind::kNote, record.place,
                  fmt::format("a robot that openr runs on this computer is 127.0.0.1: write that, "
                              "or run with --ip {}=127.0.0.1",
                              kSampleRobotAddress));
  }
}

void StickCheck::CheckDesigns() {
  const fs::path file = Config("DESIGNDB.CFG");
  if (file.empty()) return;
  const DesignConfig config = ParseDesignConfig(file, ReadText(file).value_or(""), kEveryDesign);
  remarks_->AddAll(config.diagnostics);
  for (const DesignRecord& record : config.designs) {
    if (!OnStick(record.path).empty()) continue;
    const std::string name = fs::path(record.path).filename();
    if (!parts_.FindFile(name).empty()) {
      remarks_->Add(Remark::Kind::kNote, record.path_place,
                    fmt::format("{} is not on the stick yet; {} is here, and a rule of a Makefile "
                                "or you copy it",
                                record.path, name));
      continue;
    }
    remarks_->Add(Remark::Kind::kWarning, record.path_place,
                  fmt::format("{} does not exist on the stick; FindDesignData(\"{}\") will fail",
                              record.path, record.keyword));
  }
}

void StickCheck::CheckSection(const std::string& section, const FilePosition& place) {
  if (!EqualsIgnoringCase(section, kNoDesign)) return;
  remarks_->AddConsequence(Remark::Kind::kWarning, place, kNoDesign,
                           fmt::format("no robot reads the section [{0}]: an {0} calls itself "
                                       "ERS-7 (field-notes.md 5.3); write [ERS-7]",
                                       kNoDesign));
}

// Finds records in a section for the ERS-7M2.  No robot reads such a section.
void StickCheck::CheckSections() {
  for (const ObjectRecord& record : stick_.objects) CheckSection(record.section, record.place);
  for (const ConnectRecord& record : wires_.connections)
    CheckSection(record.section, record.subject_place);
}

// Checks the network settings in WLANCONF.TXT, and finds files that were probably meant to be
// WLANCONF.TXT but are in a wrong folder or have a misspelt name.
void StickCheck::CheckWlan() {
  const fs::path folder = FindBelow(stick_.root, "OPEN-R/SYSTEM/CONF");
  const fs::path file = folder.empty() ? fs::path() : FindEntry(folder, kWlanFile);
  if (!file.empty()) {
    const WlanResult settings = ParseWlanConfig(file, ReadText(file).value_or(""));
    remarks_->AddAll(settings.diagnostics);
    remarks_->AddAll(CheckWlanSettings(file, settings));
  }
  std::vector<fs::path> files = FilesBelow(FindEntry(stick_.root, "OPEN-R"));
  const fs::path at_root = FindEntry(stick_.root, kWlanFile);
  if (!at_root.empty()) files.push_back(at_root);
  for (const fs::path& other : files) {
    const std::string name = other.filename();
    const bool is_here = other.parent_path() == folder;
    if (EqualsIgnoringCase(name, kWlanFile)) {
      if (is_here) continue;
      remarks_->Error(
          other,
          "lies in the wrong folder: the robot reads /MS/OPEN-R/SYSTEM/CONF/WLANCONF.TXT "
          "and nothing else; move it there");
    } else if (is_here && EditDistance(name, kWlanFile) <= kMisspeltDistanceMax) {
      remarks_->Warning(other, "is no file that the robot reads; did you mean WLANCONF.TXT?");
    }
  }
}

// Warns of file names that the file system of the robot's Memory Stick cannot hold.
void StickCheck::CheckFileNames() {
  const fs::path openr = FindEntry(stick_.root, "OPEN-R");
  std::set<fs::path> seen;
  for (const fs::path& file : FilesBelow(openr)) {
    if (file.extension() == ".DBG") continue;  // skips debug information, which is only for a host
    for (fs::path part = file; part != openr; part = part.parent_path()) {
      const std::string name = part.filename();
      if (IsShortName(name) || name == "VERSION.txt" || !seen.insert(part).second) continue;
      remarks_->Warning(part, fmt::format("'{}' is not an 8.3 name; the robot's file system cannot "
                                          "hold it",
                                          name));
    }
  }
}

}  // namespace

void CheckStick(const StickFolder& stick, const Project& project, const ObjectParts& parts,
                CheckTarget target, Remarks* remarks) {
  StickCheck(stick, project, parts, target, remarks).Run();
}

}  // namespace openr_host
