// The constructor of Bench, and its functions by which a test adds objects, probes and connections.
#include "testing/bench.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>

#include "cli/install_paths.h"
#include "openr/decode/decode_message.h"
#include "openr/simulation/assemble_robot.h"
#include "runtime/base/spelling.h"
#include "runtime/config/connect_config.h"
#include "runtime/config/ocf.h"
#include "runtime/config/service_name.h"
#include "runtime/core/code_object.h"
#include "runtime/core/dispatcher.h"
#include "runtime/core/image_file.h"
#include "runtime/core/load_image.h"
#include "runtime/core/load_stick.h"
#include "runtime/gateway/tcp_gateway.h"
#include "runtime/ipstack/ip_stack.h"
#include "virtualrobot/body/body.h"
#include "virtualrobot/virtual_robot.h"

namespace openr::testing {

using openr_host::Message;
using openr_host::Object;
using openr_host::ServiceName;
using openr_host::System;
using openr_host::SystemOptions;
using openr_host::TraceRecord;

namespace {

constexpr char kSeedVariable[] = "OPENR_SEED";
constexpr uint32_t kFirstClientIp = 0x0a000102;  // 10.0.1.2, in the network of the robot

std::unique_ptr<System> MakeSystem(const BenchOptions& options, std::string* console) {
  SystemOptions system_options;
  system_options.seed = options.seed;
  system_options.strict = options.strict;
  system_options.cost = options.cost;
  system_options.guard_regions = options.guard_regions;
  system_options.measure_stacks = options.measure_stacks;
  system_options.say = &openr_host::DecodeHandled;
  system_options.console = [console](std::string_view text) { console->append(text); };
  return std::make_unique<System>(std::move(system_options));
}

openr_host::World WorldOf(const std::string& name) {
  return name.empty() ? openr_host::World() : openr_host::LoadWorld(openr_host::DataFile(name));
}

std::string UpperCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::string DefaultStick() { return openr_host::DefaultStick(); }

uint64_t SeedOfEnvironment() {
  const char* const text = std::getenv(kSeedVariable);
  if (text == nullptr || *text == 0) return SystemOptions().seed;
  uint64_t seed = 0;
  const char* const end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, seed);
  if (error == std::errc() && stop == end) return seed;
  throw std::invalid_argument(
      fmt::format("{}='{}' is no number from 0 to {}", kSeedVariable, text, UINT64_MAX));
}

Bench::Bench(BenchOptions options, Place place)
    : options_(std::move(options)),
      place_(place),
      model_(std::make_unique<openr_host::RobotModel>(
          openr_host::LoadRobotModel(openr_host::ModelFile(options_.robot)))),
      world_(std::make_unique<openr_host::World>(WorldOf(options_.world))),
      stick_(std::make_shared<BenchStick>(options_.stick)),
      hub_(std::make_shared<openr_host::LoopbackHub>()),
      system_(MakeSystem(options_, &console_)),
      schedule_(system_.get(), options_.seed),
      gate_(system_.get(),
            [this](const SeenMessage& message, const Place& place) { PostAgain(message, place); }),
      command_(CommandOf(options_.seed)) {
  story_teller_ =
      std::make_unique<StoryTeller>([this] { return Story(); }, options_.handler_limit.count());
  system_->set_schedule(&schedule_);
  system_->dispatcher().set_gate(&gate_);
  system_->trace().AddSink(
      [this](const TraceRecord&, const Message& message) { HandleMessage(message); });
  AddDog();
  if (!options_.stick.empty()) LoadStick();
}

Bench::~Bench() {
  if (::testing::UnitTest::GetInstance()->current_test_info() != nullptr && !FailedFatally() &&
      std::uncaught_exceptions() == 0) {
    Verify();
  }
}

void Bench::OnCopied() {
  stick_->MoveToCopy();
  command_ = CommandOf(options_.seed);
  story_teller_->WatchRunningTest();
}

void Bench::AddDog() {
  openr_host::RobotEquipment parts;
  parts.stick = stick_;
  parts.body = openr_host::MakeBody(options_.body, *model_, *world_);
  if (parts.body == nullptr && options_.body != "none") {
    throw std::runtime_error(
        fmt::format("no body '{}'; there are: none, ideal, ode", options_.body));
  }
  if (parts.body != nullptr) {
    parts.devices = openr_host::DevicesWithBattery(options_.battery);
    parts.devices.camera = openr_host::OpenImages(options_.images);
  }
  parts.make_network = [this](int) { return std::make_unique<openr_host::LoopbackNetwork>(hub_); };
  const openr_host::AssembledRobot robot =
      openr_host::AssembleRobot(system_.get(), *model_, std::move(parts));
  dog_ = robot.virtual_robot;
  ip_stack_ = robot.ip_stack;
}

void Bench::LoadStick() {
  std::map<std::string, bool> used;
  openr_host::StandIns stand_ins;
  for (const StandIn& stand_in : options_.replace) {
    const std::string& name = stand_in.object;
    used[name] = false;
    stand_ins[name] = [this, &stand_in, &name, &used](const std::string& path) {
      used[name] = true;
      if (stand_in.make) return stand_in.make(*this);
      // Reads the object's name from its image, because the test may have given the name of the
      // image's file (`name`), and CONNECT.CFG contains only names of objects.
      const std::string in_image = NameInImage(path);
      const std::string& object = in_image.empty() ? name : in_image;
      AddProbe(object, ServicesOf(object));
    };
  }
  openr_host::LoadStick(system_.get(), 0, stand_ins, {openr_host::GatewayImage(system_.get(), 0)});
  std::vector<std::string> known;
  for (const auto& object : system_->objects()) {
    if (object->is_image()) known.push_back(object->name);
  }
  for (const auto& [name, was_used] : used) {
    if (was_used) continue;
    throw std::invalid_argument(fmt::format("replace: there is no object '{}' on the stick{}", name,
                                            openr_host::DidYouMean(name, known)));
  }
}

std::string Bench::NameInImage(const std::string& path) {
  const BenchStick::Location location = stick_->Locate(path);
  if (location.error != 0 || !location.exists) return "";
  const openr_host::ImageFile image = openr_host::ReadImageFile(location.path);
  if (!image.problem.empty()) return "";
  const auto ocf = openr_host::ParseOcf(path, openr_host::OcfTextOf(image.bytes)).ocf;
  return ocf ? ocf->name : "";
}

std::vector<std::string> Bench::ServicesOf(const std::string& object) {
  const std::string file = "CONNECT.CFG";
  const auto text = stick_->Read("/MS/OPEN-R/MW/CONF/" + file);
  std::vector<std::string> services;
  const auto add = [&](const ServiceName& name) {
    const std::string service = Compose(name);
    if (openr_host::EqualsIgnoringCase(name.object, object) &&
        std::find(services.begin(), services.end(), service) == services.end()) {
      services.push_back(service);
    }
  };
  for (const auto& connection :
       openr_host::ParseConnectConfig(file, text.value_or(""), model_->design).connections) {
    add(connection.subject);
    add(connection.observer);
  }
  return services;
}

Object& Bench::AddImage(const std::string& file) {
  const std::string name =
      "/MS/OPEN-R/MW/OBJS/" + UpperCase(std::filesystem::path(file).filename().string());
  stick_->ImportImage(file, name);
  Object* const object = openr_host::LoadImage(system_.get(), 0, name, "AddImage");
  if (object == nullptr) {
    // Allows the last finding, which says why the image was not loaded.  The exception reports the
    // same problem, and the test should not fail twice for one problem.
    AllowFinding(findings().size() - 1);
    throw std::runtime_error(findings().back().text);
  }
  return *object;
}

Probe& Bench::AddProbe(const std::string& name, const std::vector<std::string>& services) {
  Probe::CheckServices(services);
  if (system_->FindObject(0, name) != nullptr)
    throw std::invalid_argument(fmt::format("there is an object '{}' already", name));
  return Add<Probe>(name, services);
}

void Bench::Wire(const std::string& subject, const std::string& observer) {
  if (system_->booted())
    throw std::logic_error("Wire: connections are made by Boot(); wire before it");
  system_->Connect({0, subject, observer, "bench.Wire"});
}

std::vector<std::string> Bench::KnownServices() {
  std::vector<std::string> services;
  for (const auto& object : system_->objects()) {
    for (const auto& [selector, entry] : object->entry_names().names())
      services.push_back(entry.substr(0, entry.rfind(" (")));
    // Reads names of services also from the image's file, because an object that is loaded from an
    // image gives names to its services only while it boots, and this function may be called before
    // the boot.
    if (!object->is_image()) continue;
    const std::string file = stick_->Locate(object->path).path;
    for (std::string& text : openr_host::ServicesInImage(openr_host::ReadImageFile(file).bytes))
      services.push_back(std::move(text));
  }
  std::erase_if(services, [](const std::string& service) {
    return !openr_host::ParseServiceName(service, nullptr);
  });
  std::sort(services.begin(), services.end());
  services.erase(std::unique(services.begin(), services.end()), services.end());
  return services;
}

std::string Bench::FullName(const std::string& name, char direction) {
  if (openr_host::ParseServiceName(name, nullptr)) return name;
  std::vector<std::string> fitting, others, known;
  for (const std::string& service : KnownServices()) {
    const bool is_end = service.back() == direction;
    if (is_end) known.push_back(ShortName({"", service}));
    if (openr_host::NamesService(name, service)) (is_end ? fitting : others).push_back(service);
  }
  if (fitting.size() == 1) return fitting[0];
  if (!fitting.empty()) {
    throw std::invalid_argument(
        fmt::format("'{}' may be {}; write the whole name", name, fmt::join(fitting, " or ")));
  }
  if (!others.empty()) return others[0];
  const auto dots = std::count(name.begin(), name.end(), '.');
  if (dots == 0 || dots > 2) Probe::CheckServices({name});  // throws if the name is malformed
  throw std::invalid_argument(fmt::format(
      "there is no {} '{}' on this bench yet{}; add its object first, or write the "
      "whole name",
      direction == 'S' ? "subject" : "observer", name, openr_host::DidYouMean(name, known)));
}

std::pair<Probe*, std::string> Bench::AddOtherEnd(const std::string& given, char direction) {
  const std::string service = FullName(given, direction == 'O' ? 'S' : 'O');
  ServiceName name = *openr_host::ParseServiceName(service, nullptr);
  if (name.direction == direction) {
    throw std::invalid_argument(
        fmt::format("'{}' is {}", service,
                    direction == 'O' ? "an observer: Feed() it" : "a subject: Watch() it"));
  }
  name.object = fmt::format("Test{}", ++last_probe_);
  name.direction = direction;
  const std::string other = Compose(name);
  Probe& probe = AddProbe(name.object, {other});
  direction == 'O' ? Wire(service, other) : Wire(other, service);
  return {&probe, other};
}

ProbeObserver& Bench::Watch(const std::string& subject) {
  const auto [probe, service] = AddOtherEnd(subject, 'O');
  return probe->observer(service);
}

ProbeSubject& Bench::Feed(const std::string& observer) {
  const auto [probe, service] = AddOtherEnd(observer, 'S');
  return probe->subject(service);
}

Probe& Bench::probe(const std::string& name) {
  auto* const host = dynamic_cast<openr_host::CodeHost*>(&object(name));
  auto* const found = host == nullptr ? nullptr : dynamic_cast<Probe*>(host->code.get());
  if (found == nullptr) throw std::invalid_argument(fmt::format("'{}' is no probe", name));
  return *found;
}

TcpClient& Bench::AddClient() {
  const auto number = static_cast<uint32_t>(clients_.size());
  clients_.push_back(&Add<TcpClient>(fmt::format("client{}", number + 1), hub_,
                                     kFirstClientIp + number, ip_stack_->address()));
  return *clients_.back();
}

}  // namespace openr::testing
