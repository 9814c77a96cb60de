// The parts of one robot: its body, devices, power, sensors, sound and camera.
//
// Three objects share them: VirtualRobot answers the calls of OPENR::, OVirtualRobotComm runs the
// frames, OVirtualRobotAudioComm plays and records sound.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "virtualrobot/body.h"
#include "virtualrobot/camera/camera.h"
#include "virtualrobot/camera/image_source.h"
#include "virtualrobot/devices.h"
#include "virtualrobot/joint_watch.h"
#include "virtualrobot/optional_bytes.h"
#include "virtualrobot/power.h"
#include "virtualrobot/primitive_table.h"
#include "virtualrobot/safe_posture.h"
#include "virtualrobot/sensor_source.h"
#include "virtualrobot/sound/microphone.h"
#include "virtualrobot/sound/sound_sink.h"
#include "virtualrobot/sound/sound_source.h"
#include "virtualrobot/sound/speaker.h"
#include "virtualrobot/sync_keys.h"

namespace openr_host {

// The outside of a robot's speaker, microphone, camera and battery.  Every member may be left out.
struct VirtualRobotOptions {
  std::unique_ptr<SoundSink> speaker;       // null: the sound is lost
  std::unique_ptr<SoundSource> microphone;  // null: silence
  std::unique_ptr<ImageSource> camera;      // null: the test pattern
  Battery battery;                          // full at boot, and drains
};

struct RobotParts {
  // Robot `robot_index` of `system`.  `system` and `model` must outlive the parts.
  RobotParts(System* system, int robot_index, const RobotModel& model, std::unique_ptr<Body> body,
             VirtualRobotOptions options);
  RobotParts(const RobotParts&) = delete;
  RobotParts& operator=(const RobotParts&) = delete;

  // Adds a warning about the object whose code runs.
  void Warn(std::string text);

  // Draws the noise of the sensors from another seed from now on.
  void Reseed(uint64_t seed);

  void HashState(Hasher* hasher) const;

  System& system;
  const int robot_index;
  const RobotModel& model;
  const std::unique_ptr<Body> body;
  PrimitiveTable primitives;
  Devices devices;
  Power power;
  SensorSource sensors;
  SyncKeys sync_keys;
  OptionalBytes optional;
  JointWatch watch;
  Speaker speaker;
  Microphone microphone;
  CameraDevice camera;
  SafePosture safe_posture;
  int64_t first_frame = 0;  // 0 unless a test sets it
  int64_t frame = 0;        // the frame that runs now; all earlier ones are complete
};

}  // namespace openr_host
