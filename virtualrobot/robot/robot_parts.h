// The parts of one robot: its body, devices, power, sensors, sound and camera.
//
// Three classes share the parts: VirtualRobot answers the calls of OPENR::, OVirtualRobotComm runs
// the frames of 8 ms, and OVirtualRobotAudioComm plays and records sound.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "virtualrobot/body/body.h"
#include "virtualrobot/camera/camera.h"
#include "virtualrobot/camera/image_source.h"
#include "virtualrobot/devices/devices.h"
#include "virtualrobot/devices/joint_watch.h"
#include "virtualrobot/devices/primitive_table.h"
#include "virtualrobot/devices/safe_posture.h"
#include "virtualrobot/devices/sensor_source.h"
#include "virtualrobot/power/energy.h"
#include "virtualrobot/power/power.h"
#include "virtualrobot/power/protection.h"
#include "virtualrobot/robot/faults.h"
#include "virtualrobot/robot/hands.h"
#include "virtualrobot/robot/joint_targets.h"
#include "virtualrobot/robot/shared_frame.h"
#include "virtualrobot/sound/microphone.h"
#include "virtualrobot/sound/sound_sink.h"
#include "virtualrobot/sound/sound_source.h"
#include "virtualrobot/sound/speaker.h"
#include "virtualrobot/vectors/optional_bytes.h"
#include "virtualrobot/vectors/sync_keys.h"

namespace openr_host {

// The options of a robot: a sink for the sound of its speaker, sources for the sound of its
// microphones and the pictures of its camera, a battery, and a SharedFrame if other robots are in
// the same world.  Every member may be left out.
struct VirtualRobotOptions {
  std::unique_ptr<SoundSink> speaker;       // receiver of sounds; null: they are not stored
  std::unique_ptr<SoundSource> microphone;  // source of sound; null: silence
  std::unique_ptr<ImageSource> camera;      // source of pictures; null: the robot's world
  Battery battery;  // the battery; by default it is full at boot, and drains
  std::shared_ptr<SharedFrame> shared_frame = nullptr;  // null: the robot is alone in its world
};

// The names of the two system objects of a robot.
constexpr char kVirtualRobotComm[] = "OVirtualRobotComm";
constexpr char kVirtualRobotAudioComm[] = "OVirtualRobotAudioComm";

struct RobotParts {
  // Makes the parts of robot `robot_index` of `system`.  `system` and `model` must outlive the
  // parts.
  RobotParts(System* system, int robot_index, const RobotModel& model, std::unique_ptr<Body> body,
             VirtualRobotOptions options);
  RobotParts(const RobotParts&) = delete;
  RobotParts& operator=(const RobotParts&) = delete;

  // Adds the warning `text` to the findings of the run.  The warning is about the object whose
  // handler runs now.
  void Warn(std::string text);

  // Switches the devices off and sets the parts to their state at boot.  The body, the battery, the
  // clock, the faults and the hands (a person's actions on the robot) keep their state.  The files
  // of speaker, microphone and camera go on at their present positions.
  void SwitchOff();

  // Computes the heat and the battery load of a frame of 8 ms, after the body has moved.  Returns
  // the reasons for which the robot now shuts down to protect itself; none while the robot is off.
  std::vector<Protection::Reason> NoteFrame(bool is_on);

  // Makes the noise of the sensors start again from `seed`.
  void Reseed(uint64_t seed);

  // Gives the sensors the noise that robot `number` of a run has, for a process that runs only this
  // robot of a larger run.  REQUIRES: no frame has run yet.
  void UseNoiseOf(int number);

  void HashState(Hasher* hasher) const;

  System& system;
  const int robot_index;
  const RobotModel& model;
  const std::unique_ptr<Body> body;
  const std::shared_ptr<SharedFrame> shared_frame;
  PrimitiveTable primitives;
  Devices devices;
  Power power;
  Energy energy;
  Protection protection;
  SensorSource sensors;
  SyncKeys sync_keys;
  OptionalBytes optional;
  JointWatch watch;
  Speaker speaker;
  Microphone microphone;
  CameraDevice camera;
  SafePosture safe_posture;
  Hands hands{this};
  Faults faults{this};
  JointTargets targets{this};
  int64_t first_frame = 0;  // number of the first frame; 0 unless a test sets it
  // Number of the frame that runs now, counted from the last boot.  All earlier frames are
  // complete.
  int64_t frame = 0;
};

}  // namespace openr_host
