// Samples all sensors, frame by frame, and makes sensor vectors of the samples.  A frame is 8 ms; a
// sensor vector is a message with the samples of four frames.
#pragma once

#include <OPENR/ODataFormats.h>
#include <OPENR/RCRegion.h>

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "runtime/base/rng.h"
#include "virtualrobot/body/body.h"
#include "virtualrobot/devices/devices.h"
#include "virtualrobot/devices/primitive_table.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/vectors/optional_bytes.h"
#include "virtualrobot/vectors/vector_memory.h"

namespace openr_host {

class Hasher;

// The kinds of faults that a sensor can have.
enum class SensorFaultKind {
  kStuck,  // the sensor goes on giving the value that it had when the fault began
  kNoisy,  // the values of the sensor have random errors
  kDead,   // the sensor gives no values
};
struct SensorFault {
  SensorFaultKind kind = SensorFaultKind::kDead;
  int percent = 0;  // for kNoisy: the highest error, in percent of the sensor's range
};

class SensorSource {
 public:
  // Number of frames in a sensor vector (Level 2 Reference Guide, 3.1).
  static constexpr int kFramesPerVector = 4;

  // Makes the sensors of a robot.  `noise` is the random generator of their noise; `fault_noise` is
  // the random generator of sensors with the fault kNoisy.  `model` and `primitives` must outlive
  // this SensorSource.
  SensorSource(const RobotModel& model, const PrimitiveTable& primitives, Rng noise,
               Rng fault_noise);

  void set_noise(Rng noise, Rng fault_noise) {
    noise_ = noise;
    fault_noise_ = fault_noise;
  }

  // Takes the samples of frame `frame`.  Returns whether these samples complete a vector.
  bool Sample(int64_t frame, const Body& body, const Devices& devices);

  // Samples all sensors now, so that Latest() returns the new samples; no vector contains them.
  // Sensors that are measured in turn are all measured.  Called when a program reads a sensor
  // before the first frame is over.
  void SampleNow(const Body& body, const Devices& devices) { SampleTurn(kAllTurns, body, devices); }

  // Returns the newest sample of element `sensor` of the sensor vector.  For a joint, its bytes are
  // an OJointValue.
  const OSensorValue& Latest(int sensor) const { return latest_[static_cast<size_t>(sensor)]; }

  // Returns a vector with the samples of the four newest frames.  The vector is in a free region:
  // only this SensorSource holds a reference to it.  REQUIRES: Sample() has just returned true, and
  // a handler of an object runs, because a new region belongs to the object that runs.
  RCRegion* MakeVector(const OptionalBytes& optional);

  // Sets the temperature that the sensor of the body's temperature measures, in degrees Celsius.
  void set_body_c(int celsius) { body_c_ = celsius; }

  // Makes sensor `sensor` read `value`, in its OPEN-R unit, until Release().  REQUIRES: `sensor` is
  // not the sensor of a joint.
  void Hold(int sensor, slongword value);
  void Release(int sensor) { held_[static_cast<size_t>(sensor)].reset(); }

  // Makes sensor `sensor` faulty until Repair().  REQUIRES: `sensor` is not the sensor of a joint.
  // The fault of a joint's sensor is in Devices::Disturbance() instead, because the servo uses this
  // sensor, too.
  void Break(int sensor, const SensorFault& fault);
  // Ends the fault of sensor `sensor`.
  void Repair(int sensor);

  // Returns a random number from -1 to 1, for the error of a noisy sensor.
  double FaultNoise() {
    is_fault_noise_used_ = true;
    return 2.0 * fault_noise_.NextDouble() - 1.0;
  }

  // Switches the sensors off with the robot: drops the samples that are not in a vector yet, and
  // the references to the regions of all vectors.  REQUIRES: the object that sends the vectors is
  // the current object.
  void SwitchOff();

  void HashState(Hasher* hasher) const;

 private:
  // The state of a joint from which the newest sample of its sensor was computed.
  struct JointReading {
    // Angle that the sensor measured.  At first it is infinity, which equals no angle, so the first
    // sample is always computed.
    double angle_rad = std::numeric_limits<double>::infinity();
    double drive = 0;
    slongword target_urad = 0;
    bool is_dead = false;
    bool operator==(const JointReading&) const = default;
  };

  // The value of the parameter `turn` of SampleTurn() with which all sensors are measured, also
  // both distance sensors of an ERS-7, which otherwise take turns.
  static constexpr int kAllTurns = -1;

  // Samples all sensors.  Of two sensors that are measured in turn (Sensor::turn), only number
  // `turn` is measured; the other keeps its value.
  void SampleTurn(int turn, const Body& body, const Devices& devices);
  void SampleJoint(size_t index, int joint, const BodyState& state, const Devices& devices);
  bool IsPressed(const BodyState& state, size_t paw) const;
  slongword ValueOf(const Sensor& sensor, const Body& body);
  slongword DistanceOf(const Sensor& sensor, const Body& body);
  void ApplyFault(const SensorFault& fault, const Sensor& sensor, slongword before,
                  OSensorValue* value);
  RCRegion* FreeVector();

  const RobotModel& model_;
  const PrimitiveTable& primitives_;
  Rng noise_, fault_noise_;
  // Whether FaultNoise() was called.  Before the first call, HashState() leaves out the generator
  // of this noise.
  bool is_fault_noise_used_ = false;
  std::vector<OSensorValue> latest_;
  std::vector<JointReading> readings_;          // an element for each joint
  std::vector<std::optional<slongword>> held_;  // for each sensor, the value that Hold() has set
  std::map<int, SensorFault> faults_;           // the key is the index of the sensor
  std::vector<OSensorValue> frames_;  // for each frame of a vector, the samples of all sensors
  int body_c_ = 30;
  bool has_sample_ = false;  // whether a sample was taken since the robot was switched on
  int64_t first_frame_ = 0;  // number of the first frame whose samples are in frames_
  // Number of frames whose samples are in frames_ already; with kFramesPerVector frames, the next
  // sensor vector is complete.
  int collected_ = 0;
  VectorPool pool_;
};

}  // namespace openr_host
