#include "virtualrobot/devices/primitive_table.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/base/hasher.h"
#include "virtualrobot/devices/primitive_locator.h"

namespace openr_host {
namespace {

OPrimitiveType TypeOf(const std::string& locator) {
  static const std::pair<const char*, OPrimitiveType> kTypes[] = {
      {oprimitiveSENSOR_NAME, oprimitiveSENSOR},
      {oprimitiveSPEAKER_NAME, oprimitiveSPEAKER},
      {oprimitiveMIC_NAME, oprimitiveMIC},
      {oprimitiveFBKIMAGESENSOR_NAME, oprimitiveFBKIMAGESENSOR},
      {oprimitiveJOINT2_NAME, oprimitiveJOINT2},
      {oprimitiveJOINT3_NAME, oprimitiveJOINT3},
      {oprimitiveJOINT4_NAME, oprimitiveJOINT4},
      {oprimitiveLED2_NAME, oprimitiveLED2},
      {oprimitiveLED3_NAME, oprimitiveLED3},
  };
  // Takes the type of the primitive from its locator, because each locator ends in "-Type:name".
  const size_t dash = locator.rfind('-');
  const size_t colon = locator.rfind(':');
  if (dash == std::string::npos || colon < dash) return oprimitiveUNDEF;
  const std::string word = locator.substr(dash + 1, colon - dash - 1);
  for (const auto& [name, type] : kTypes) {
    if (word == name) return type;
  }
  return oprimitiveUNDEF;
}

// Calls visit(locator, kind, index, sensor) for each primitive of a robot, in the order of their
// ids.  The arguments `index` and `sensor` are the values for the members Primitive::index and
// Primitive::sensor.
template <typename Visit>
void VisitPrimitives(const RobotModel& model, const Visit& visit) {
  for (size_t i = 0; i < model.sensors.size(); ++i) {
    const Sensor& sensor = model.sensors[i];
    const bool is_joint = sensor.kind == SensorKind::kJoint && sensor.joint >= 0;
    visit(sensor.locator, is_joint ? PrimitiveKind::kJoint : PrimitiveKind::kSensor,
          is_joint ? sensor.joint : static_cast<int>(i), static_cast<int>(i));
  }
  for (size_t i = 0; i < model.plungers.size(); ++i) {
    visit(model.plungers[i].locator, PrimitiveKind::kPlunger, static_cast<int>(i), -1);
  }
  for (size_t i = 0; i < model.leds.size(); ++i) {
    visit(model.leds[i].locator, PrimitiveKind::kLed, static_cast<int>(i), -1);
  }
  visit(model.speaker_locator, PrimitiveKind::kSpeaker, 0, -1);
  visit(model.microphone_locator, PrimitiveKind::kMicrophone, 0, -1);
  visit(model.camera.locator, PrimitiveKind::kCamera, 0, -1);
}

}  // namespace

PrimitiveTable::PrimitiveTable(const RobotModel& model) {
  VisitPrimitives(model, [this](const std::string& locator, PrimitiveKind kind, int index,
                                int sensor) { Add(locator, kind, index, sensor); });
}

const std::string* PrimitiveLocator(const RobotModel& model, OPrimitiveID id) {
  static const OPrimitiveID first = PrimitiveTable(RobotModel()).IdOfSensor(0);
  const std::string* found = nullptr;
  OPrimitiveID next = first;
  VisitPrimitives(model, [&](const std::string& locator, PrimitiveKind, int, int) {
    if (next++ == id) found = &locator;
  });
  // Returns null for an empty locator, too, because a model without a microphone, for example, has
  // an empty locator for it.
  return found == nullptr || found->empty() ? nullptr : found;
}

void PrimitiveTable::Add(const std::string& locator, PrimitiveKind kind, int index, int sensor) {
  ids_[locator] = kFirstId + static_cast<OPrimitiveID>(primitives_.size());
  primitives_.push_back({locator, kind, TypeOf(locator), index, sensor});
}

OPrimitiveID PrimitiveTable::IdOf(const std::string& locator) const {
  const auto found = ids_.find(locator);
  return found == ids_.end() ? oprimitiveID_UNDEF : found->second;
}

Primitive* PrimitiveTable::Find(OPrimitiveID id) {
  const OPrimitiveID index = id - kFirstId;
  return index < primitives_.size() ? &primitives_[index] : nullptr;
}

void PrimitiveTable::CloseAll() {
  for (Primitive& primitive : primitives_) primitive.open_count = 0;
}

std::string PrimitiveTable::Lines() const {
  std::string lines;
  for (size_t i = 0; i < primitives_.size(); ++i)
    lines += fmt::format("{} {}\n", kFirstId + i, primitives_[i].locator);
  return lines;
}

void PrimitiveTable::HashState(Hasher* hasher) const {
  for (const Primitive& primitive : primitives_) hasher->Add(primitive.open_count);
}

}  // namespace openr_host
