#include "virtualrobot/primitive_table.h"

namespace openr_host {

PrimitiveTable::PrimitiveTable(const RobotModel& model) {
  for (size_t i = 0; i < model.sensors.size(); ++i) {
    const Sensor& sensor = model.sensors[i];
    const bool is_joint = sensor.kind == SensorKind::kJoint && sensor.joint >= 0;
    Add(sensor.locator, is_joint ? PrimitiveKind::kJoint : PrimitiveKind::kSensor,
        is_joint ? sensor.joint : static_cast<int>(i), static_cast<int>(i));
  }
  for (size_t i = 0; i < model.plungers.size(); ++i) {
    Add(model.plungers[i].locator, PrimitiveKind::kPlunger, static_cast<int>(i), -1);
  }
  for (size_t i = 0; i < model.leds.size(); ++i) {
    Add(model.leds[i].locator, PrimitiveKind::kLed, static_cast<int>(i), -1);
  }
  Add(model.speaker_locator, PrimitiveKind::kSpeaker, 0, -1);
  Add(model.microphone_locator, PrimitiveKind::kMicrophone, 0, -1);
  Add(model.camera.locator, PrimitiveKind::kCamera, 0, -1);
}

void PrimitiveTable::Add(const std::string& locator, PrimitiveKind kind, int index, int sensor) {
  ids_[locator] = kFirstId + static_cast<OPrimitiveID>(primitives_.size());
  primitives_.push_back({locator, kind, index, sensor, false});
}

OPrimitiveID PrimitiveTable::IdOf(const std::string& locator) const {
  const auto found = ids_.find(locator);
  return found == ids_.end() ? oprimitiveID_UNDEF : found->second;
}

Primitive* PrimitiveTable::Find(OPrimitiveID id) {
  const OPrimitiveID index = id - kFirstId;
  return index < primitives_.size() ? &primitives_[index] : nullptr;
}

}  // namespace openr_host
