#include "openr/explore/deviation.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "cli/json_text.h"
#include "openr/explore/fault_line.h"
#include "runtime/core/system.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kKindNames[] = {"start", "tie", "delay", "cost", "frame", "fault"};

// Sets the member `field` of `json` to the name of the object `id`, and the member "robot" to the
// number of its robot.
void PutObject(const System& system, ObjectId id, const char* field, Json* json) {
  const Object* const object = system.object(id);
  (*json)["robot"] = object->robot;
  (*json)[field] = object->name;
}

ObjectId ObjectOf(const Json& json, const char* field, const System& system) {
  const std::string name = json.at(field).get<std::string>();
  const int robot = json.at("robot").get<int>();
  const Object* const object = system.FindObject(robot, name);
  if (object == nullptr) {
    throw std::runtime_error(
        fmt::format("no object '{}' on robot {}; the schedule is of another "
                    "graph",
                    name, robot));
  }
  return object->id;
}

Deviation::Kind KindOf(const std::string& name) {
  for (size_t i = 0; i < std::size(kKindNames); ++i) {
    if (name == kKindNames[i]) return static_cast<Deviation::Kind>(i);
  }
  throw std::runtime_error(fmt::format(
      "no kind of deviation '{}'; there are start, tie, delay, cost, frame, fault", name));
}

Json FaultToJson(const Deviation& fault, const System& system) {
  const auto* const robot = dynamic_cast<const VirtualRobot*>(
      system.robot(static_cast<int>(fault.selector)).services.get());
  return {{"kind", "fault"},
          {"time_us", fault.time_us},
          {"nth", fault.nth},
          {"robot", fault.selector},
          {"line", robot == nullptr ? "" : FaultLine(robot->model(), fault.us)},
          {"us", fault.us}};
}

Deviation FaultFromJson(const Json& json, const System& system) {
  Deviation fault;
  fault.kind = Deviation::Kind::kFault;
  fault.time_us = json.at("time_us").get<int64_t>();
  fault.nth = json.at("nth").get<uint64_t>();
  fault.selector = json.at("robot").get<uint32_t>();
  fault.us = json.at("us").get<int64_t>();
  if (fault.time_us < 0) throw std::runtime_error("a fault before the run, at a time below 0");
  const int64_t robot = json["robot"].get<int64_t>();
  if (robot < 0 || robot >= system.robot_count())
    throw std::runtime_error(fmt::format("no robot {}; the schedule is of another run", robot));
  return fault;
}

}  // namespace

Json DeviationToJson(const Deviation& deviation, const System& system) {
  const Deviation::Kind kind = deviation.kind;
  if (kind == Deviation::Kind::kFault) return FaultToJson(deviation, system);
  Json json = {{"kind", kKindNames[static_cast<size_t>(kind)]}};
  if (kind != Deviation::Kind::kStart && kind != Deviation::Kind::kFrame)
    json["time_us"] = deviation.time_us;
  json["nth"] = deviation.nth;
  if (kind != Deviation::Kind::kFrame) PutObject(system, deviation.object, "object", &json);
  if (kind == Deviation::Kind::kDelay) PutObject(system, deviation.sender, "sender", &json);
  if (kind == Deviation::Kind::kDelay || kind == Deviation::Kind::kCost) {
    json["selector"] = deviation.selector;
    json["entry"] = system.object(deviation.object)->EntryName(deviation.selector);
  }
  if (kind != Deviation::Kind::kStart && kind != Deviation::Kind::kTie) json["us"] = deviation.us;
  return json;
}

Deviation DeviationFromJson(const Json& json, const System& system) try {
  Deviation deviation;
  const Deviation::Kind kind = KindOf(json.at("kind").get<std::string>());
  if (kind == Deviation::Kind::kFault) return FaultFromJson(json, system);
  deviation.kind = kind;
  deviation.nth = json.at("nth").get<uint64_t>();
  if (kind != Deviation::Kind::kStart && kind != Deviation::Kind::kFrame) {
    deviation.time_us = json.at("time_us").get<int64_t>();
  }
  if (kind != Deviation::Kind::kFrame) deviation.object = ObjectOf(json, "object", system);
  if (kind == Deviation::Kind::kDelay) deviation.sender = ObjectOf(json, "sender", system);
  if (kind == Deviation::Kind::kDelay || kind == Deviation::Kind::kCost) {
    deviation.selector = json.at("selector").get<uint32_t>();
  }
  if (kind != Deviation::Kind::kStart && kind != Deviation::Kind::kTie)
    deviation.us = json.at("us").get<int64_t>();
  return deviation;
} catch (const Json::exception& error) {
  throw std::runtime_error(fmt::format("deviation {}: {}", JsonText(json), error.what()));
}

}  // namespace openr_host
