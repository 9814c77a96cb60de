#include "openr/explore/deviation.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "runtime/core/system.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;
using Kind = Deviation::Kind;

constexpr const char* kKindNames[] = {"start", "tie", "delay", "cost", "frame"};

// Sets `field` of `json` to the name of object `id`, and "robot" to the number of its robot.
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

Kind KindOf(const std::string& name) {
  for (size_t i = 0; i < std::size(kKindNames); ++i) {
    if (name == kKindNames[i]) return static_cast<Kind>(i);
  }
  throw std::runtime_error(
      fmt::format("no kind of deviation '{}'; there are start, tie, delay, cost, frame", name));
}

}  // namespace

Json DeviationToJson(const Deviation& deviation, const System& system) {
  const Kind kind = deviation.kind;
  Json json = {{"kind", kKindNames[static_cast<size_t>(kind)]}};
  if (kind != Kind::kStart && kind != Kind::kFrame) json["time_us"] = deviation.time_us;
  json["nth"] = deviation.nth;
  if (kind != Kind::kFrame) PutObject(system, deviation.object, "object", &json);
  if (kind == Kind::kDelay) PutObject(system, deviation.sender, "sender", &json);
  if (kind == Kind::kDelay || kind == Kind::kCost) {
    json["selector"] = deviation.selector;
    json["entry"] = system.object(deviation.object)->EntryName(deviation.selector);
  }
  if (kind != Kind::kStart && kind != Kind::kTie) json["us"] = deviation.us;
  return json;
}

Deviation DeviationFromJson(const Json& json, const System& system) try {
  Deviation deviation;
  const Kind kind = KindOf(json.at("kind").get<std::string>());
  deviation.kind = kind;
  deviation.nth = json.at("nth").get<uint64_t>();
  if (kind != Kind::kStart && kind != Kind::kFrame) {
    deviation.time_us = json.at("time_us").get<int64_t>();
  }
  if (kind != Kind::kFrame) deviation.object = ObjectOf(json, "object", system);
  if (kind == Kind::kDelay) deviation.sender = ObjectOf(json, "sender", system);
  if (kind == Kind::kDelay || kind == Kind::kCost) {
    deviation.selector = json.at("selector").get<uint32_t>();
  }
  if (kind != Kind::kStart && kind != Kind::kTie) deviation.us = json.at("us").get<int64_t>();
  return deviation;
} catch (const Json::exception& error) {
  throw std::runtime_error(fmt::format("deviation {}: {}", json.dump(), error.what()));
}

}  // namespace openr_host
