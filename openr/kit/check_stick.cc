#include "openr/kit/check_stick.h"

#include <OPENR/OPENRServices.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>

#include "openr/kit/check_objects.h"
#include "openr/kit/image_match.h"
#include "openr/kit/sdk_paths.h"
#include "openr/kit/text_files.h"
#include "runtime/config/address_config.h"
#include "runtime/config/connect_config.h"
#include "runtime/config/design_config.h"
#include "runtime/config/gateway_config.h"
#include "runtime/config/line_file.h"
#include "runtime/config/ocf.h"
#include "runtime/config/spelling.h"
#include "runtime/config/wlan_config.h"
#include "runtime/core/image_file.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// The address in the files of the original; a robot that openr runs here has another one.
constexpr char kRobotOfThatTime[] = "10.0.1.100";

// Services the robot itself registers.
const char* const kRobotServices[] = {ovrcommSENSOR, ovrcommEFFECTOR, ovrcommFBK,
                                      ovrcommMIC,    ovrcommSPEAKER,  ovrcommALERT};

// The name in the .ocf text that images for the host carry; "" when there is none.
std::string ObjectNameIn(std::string_view bytes) {
  for (const std::string_view text : TextsIn(bytes)) {
    if (text.find("object") == std::string_view::npos) continue;
    const OcfResult ocf = ParseOcf("", text);
    if (ocf.ocf) return ocf.ocf->name;
  }
  return "";
}

class StickCheck {
 public:
  StickCheck(const StickFolder& stick, const Project& project, Remarks* remarks)
      : stick_(stick), project_(project), remarks_(remarks) {}

  void Run() {
    for (const char* service : kRobotServices) services_[service] = "the robot";
    CheckObjectConfig();
    CheckConnections();
    CheckGateway();
    CheckDesigns();
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

  void CheckObjectConfig();
  void CheckImage(const ObjectRecord& record, const fs::path& file);
  void ExpectFromProject(const std::vector<ObjectRecord>& missing);
  void AddStubServices(const ObjectFolder& object);
  void CheckConnections();
  void CheckService(const ServiceName& name, const Place& place);
  void CheckUnconnected(const std::set<std::string>& connected);
  void CheckGateway();
  void NoteOldAddresses(const GatewayConfig& host);
  GatewayConfig ReadGateway(const fs::path& file, GatewaySide side);
  void CheckDesigns();
  void CheckWlan();
  void CheckFileNames();

  const StickFolder& stick_;
  const Project& project_;
  Remarks* const remarks_;
  std::map<std::string, std::string> services_;  // by full name: who has it
  std::vector<StubService> declared_;            // in stub.cfg files of objects on the stick
  ConnectConfig wires_;
  bool has_gateway_ = false;                         // in OBJECT.CFG
  std::map<std::string, std::string> object_names_;  // of images: by which file
  bool knows_all_ = true;                            // false: some image could not be looked into
};

void StickCheck::CheckObjectConfig() {
  if (stick_.object_config.empty()) {
    remarks_->Error((stick_.root / "OPEN-R/MW/CONF/OBJECT.CFG").string(),
                    "is missing; it lists the images to load, one path a line");
    return;
  }
  const std::string text = ReadText(stick_.object_config).value_or("");
  const ObjectConfig config = ParseObjectConfig(stick_.object_config, text, kEveryDesign);
  remarks_->AddAll(config.diagnostics);
  bool has_power_monitor = false;
  std::vector<ObjectRecord> missing;
  for (const ObjectRecord& record : config.objects) {
    const std::string name = FileNameOf(record);
    has_power_monitor = has_power_monitor || EqualsIgnoringCase(name, "POWERMON.BIN");
    if (std::any_of(record.path.begin(), record.path.end(),
                    [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0; })) {
      remarks_->Add(Remark::Kind::kNote, record.place,
                    "lower case in a path; the stick keeps names in upper case");
    }
    const fs::path file = OnStick(record.path);
    if (EqualsIgnoringCase(name, kGatewayImage)) {  // the system's own
      has_gateway_ = true;
    } else if (file.empty()) {
      missing.push_back(record);
    } else {
      CheckImage(record, file);
    }
  }
  ExpectFromProject(missing);
  if (!has_power_monitor && !config.objects.empty()) {
    remarks_->Note(stick_.object_config,
                   "no POWERMON.BIN: nothing handles the pause button and an empty battery");
  }
}

void StickCheck::CheckImage(const ObjectRecord& record, const fs::path& file) {
  const ImageFile image = ReadImageFile(file);
  if (!image.problem.empty()) {
    remarks_->Add(Remark::Kind::kError, record.place,
                  fmt::format("{} {}", record.path, image.problem));
  }
  if (image.bytes.empty()) return;
  const std::vector<std::string> names = ServicesInImage(image.bytes);
  for (const std::string& name : names) services_.emplace(name, FileNameOf(record));
  if (image.problem.empty() || image.is_for_robot) {
    const std::string name = ObjectNameIn(image.bytes);
    if (name.empty()) return;
    const auto [first, is_new] = object_names_.emplace(name, FileNameOf(record));
    // Sections of several robots may name the same image.
    if (!is_new && !EqualsIgnoringCase(first->second, FileNameOf(record))) {
      remarks_->Add(
          Remark::Kind::kError, record.place,
          fmt::format("its object is named '{}' like that of {}; names in .ocf files must "
                      "differ",
                      name, first->second));
    }
    for (const ObjectFolder& object : project_.objects) {
      for (const fs::path& ocf : object.ocfs) {
        const OcfResult parsed = ParseOcf("", ReadText(ocf).value_or(""));
        if (parsed.ocf && parsed.ocf->name == name) AddStubServices(object);
      }
    }
  }
}

// Images that are not there: which objects of the project would be they?
void StickCheck::ExpectFromProject(const std::vector<ObjectRecord>& missing) {
  std::vector<std::string> wanted;
  for (const ObjectRecord& record : missing) wanted.push_back(FileNameOf(record));
  std::vector<ImageCandidate> candidates;
  for (const ObjectFolder& object : project_.objects) {
    ImageCandidate& candidate = candidates.emplace_back();
    candidate.names = object.image_names;
    candidate.names.push_back(object.folder.filename().string() + ".");
    candidate.names.push_back(object.class_name + ".");
    for (const fs::path& ocf : object.ocfs) {
      candidate.names.push_back(ocf.filename());
      const OcfResult parsed = ParseOcf("", ReadText(ocf).value_or(""));
      if (parsed.ocf) candidate.names.push_back(parsed.ocf->name + ".");
    }
  }
  std::vector<std::string> there;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(stick_.ObjectsFolder(), error))
    there.push_back(entry.path().filename());
  std::sort(there.begin(), there.end());
  const std::vector<int> matches = MatchImages(wanted, candidates);
  for (size_t i = 0; i < missing.size(); ++i) {
    const ObjectRecord& record = missing[i];
    if (matches[i] >= 0) {
      const ObjectFolder& object = project_.objects[static_cast<size_t>(matches[i])];
      remarks_->Add(Remark::Kind::kNote, record.place,
                    fmt::format("not built yet; 'openr build' makes it of {}",
                                object.folder.filename().string()));
      AddStubServices(object);
    } else if (!project_.objects.empty() && EqualsIgnoringCase(wanted[i], "POWERMON.BIN")) {
      remarks_->Add(Remark::Kind::kNote, record.place,
                    "not built here; 'openr build' puts the kit's own there");
    } else {
      knows_all_ = false;
      remarks_->Add(Remark::Kind::kError, record.place,
                    fmt::format("{} does not exist on the stick; the robot stops with error 90{}",
                                record.path, DidYouMean(wanted[i], there)));
    }
  }
}

void StickCheck::AddStubServices(const ObjectFolder& object) {
  if (object.stub.empty()) {
    knows_all_ = false;
    return;
  }
  const StubConfig stub = ParseStubConfig(object.stub, ReadText(object.stub).value_or("")).config;
  for (const auto* side : {&stub.subjects, &stub.observers}) {
    for (const StubService& service : *side) {
      services_[Compose(service.name)] = object.folder.filename();
      declared_.push_back(service);
    }
  }
}

void StickCheck::CheckService(const ServiceName& name, const Place& place) {
  const std::string full = Compose(name);
  if (services_.contains(full) || full.starts_with(kGatewayPrefix)) return;
  std::vector<std::string> known;
  for (const auto& [service, owner] : services_) {
    known.push_back(service);
    const auto other = ParseServiceName(service, nullptr);
    if (!other || !DifferInDataOnly(*other, name)) continue;
    remarks_->Add(Remark::Kind::kError, place,
                  fmt::format("'{}' has the data type '{}' in {}, not '{}'; the line is skipped",
                              full, other->data, owner, name.data));
    return;
  }
  remarks_->Add(knows_all_ ? Remark::Kind::kError : Remark::Kind::kWarning, place,
                fmt::format("no object on this stick has '{}': NOT FOUND, the line is skipped{}",
                            full, DidYouMean(full, known)));
}

void StickCheck::CheckConnections() {
  const fs::path file = Config("CONNECT.CFG");
  if (file.empty()) {
    remarks_->Warning((stick_.root / "OPEN-R/MW/CONF/CONNECT.CFG").string(),
                      "is missing; no object is connected");
    return;
  }
  wires_ = ParseConnectConfig(file, ReadText(file).value_or(""), kEveryDesign);
  remarks_->AddAll(wires_.diagnostics);
  std::set<std::string> connected;
  for (const ConnectRecord& record : wires_.connections) {
    CheckService(record.subject, record.subject_place);
    CheckService(record.observer, record.observer_place);
    connected.insert(Compose(record.subject));
    connected.insert(Compose(record.observer));
  }
  CheckUnconnected(connected);
}

void StickCheck::CheckUnconnected(const std::set<std::string>& connected) {
  for (const StubService& service : declared_) {
    if (IsDummy(service) || connected.contains(Compose(service.name))) continue;
    if (service.connect_function.empty() && service.data_function.empty()) continue;
    remarks_->Add(Remark::Kind::kNote, service.place,
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

// What the gateway is to carry, and what is wired to it.
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
  if (!robot_file.empty() && !has_gateway_) {
    remarks_->Warning(stick_.object_config,
                      fmt::format("does not name /MS/OPEN-R/SYSTEM/OBJS/{}; {} has no effect on "
                                  "the robot then",
                                  kGatewayImage, kRobotGatewayFile));
  }
  if (robot_file.empty() && has_gateway_) {
    remarks_->Warning(stick_.object_config,
                      fmt::format("names {}, but there is no {} beside it: the gateway has no "
                                  "services",
                                  kGatewayImage, kRobotGatewayFile));
  }
}

// A robot that runs on this computer has another address than the dog of that time.
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
    if (record.host != kRobotOfThatTime || is_mapped) continue;
    remarks_->Add(Remark::Kind::kNote, record.place,
                  fmt::format("a robot that openr runs on this computer is 127.0.0.1: write that, "
                              "or run with --ip {}=127.0.0.1",
                              kRobotOfThatTime));
  }
}

void StickCheck::CheckDesigns() {
  const fs::path file = Config("DESIGNDB.CFG");
  if (file.empty()) return;
  const DesignConfig config = ParseDesignConfig(file, ReadText(file).value_or(""), kEveryDesign);
  remarks_->AddAll(config.diagnostics);
  for (const DesignRecord& record : config.designs) {
    if (!OnStick(record.path).empty()) continue;
    remarks_->Add(Remark::Kind::kWarning, record.path_place,
                  fmt::format("{} does not exist on the stick; FindDesignData(\"{}\") will fail",
                              record.path, record.keyword));
  }
}

void StickCheck::CheckWlan() {
  const fs::path file = FindBelow(stick_.root, "OPEN-R/SYSTEM/CONF/WLANCONF.TXT");
  if (!file.empty())
    remarks_->AddAll(ParseWlanConfig(file, ReadText(file).value_or("")).diagnostics);
}

// Names that no Memory Stick holds.
void StickCheck::CheckFileNames() {
  const fs::path openr = FindEntry(stick_.root, "OPEN-R");
  std::set<fs::path> seen;
  for (const fs::path& file : FilesBelow(openr)) {
    if (file.extension() == ".DBG") continue;  // of the host
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

void CheckStick(const StickFolder& stick, const Project& project, Remarks* remarks) {
  StickCheck(stick, project, remarks).Run();
}

}  // namespace openr_host
