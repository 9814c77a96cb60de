// Samples of all sensors, frame by frame, and the sensor vectors made of them.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/RCRegion.h>

#include <cstdint>
#include <vector>

#include "runtime/base/rng.h"
#include "virtualrobot/body.h"
#include "virtualrobot/devices.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/optional_bytes.h"
#include "virtualrobot/primitive_table.h"
#include "virtualrobot/vector_memory.h"

namespace openr_host {

class Hasher;

class SensorSource {
 public:
  static constexpr int kFramesPerVector = 4;  // Level 2 Reference Guide, 3.1

  // `noise` is the generator of this robot's sensor noise.
  SensorSource(const RobotModel& model, const PrimitiveTable& primitives, Rng noise);

  void set_noise(Rng noise) { noise_ = noise; }

  // Takes the samples of frame `frame`.  Returns whether a vector is complete with them.
  bool Sample(int64_t frame, const Body& body, const Devices& devices);

  // Takes samples that belong to no vector, for a program that reads a sensor before the first
  // frame is over.
  void SampleNow(const Body& body, const Devices& devices);

  // The newest sample of one element (OJointValue for joints).
  const OSensorValue& Latest(int sensor) const { return latest_[static_cast<size_t>(sensor)]; }

  // A vector with the four newest frames, in a region to which no object refers.  The one reference
  // to the region stays here.  REQUIRES: Sample() has just returned true.  Runs as code of an
  // object.
  RCRegion* MakeVector(const OptionalBytes& optional);

  void HashState(Hasher* hasher) const;

 private:
  OSensorValue ValueOf(const Sensor& sensor, const Body& body, const Devices& devices);
  OSensorValue JointValueOf(int joint, const Body& body, const Devices& devices) const;
  slongword DistanceOf(const Sensor& sensor, const Body& body);
  RCRegion* FreeVector();

  const RobotModel& model_;
  const PrimitiveTable& primitives_;
  Rng noise_;
  std::vector<OSensorValue> latest_;
  std::vector<OSensorValue> frames_;  // [frame][sensor], kFramesPerVector frames
  int64_t first_frame_ = 0;           // number of frames_[0]
  int collected_ = 0;  // frames of the next vector that are in frames_; below kFramesPerVector
  VectorPool pool_;
};

}  // namespace openr_host
