#include "virtualrobot/devices/sensor_source.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/robot.h"
#include "virtualrobot/vectors/frame_number.h"

namespace openr_host {
namespace {

constexpr double kMicro = 1e6;  // sensor values are in millionths of their SI unit
// Largest output of the 10-bit A/D converter (Level 2 Reference Guide, 4.2.2).
constexpr int kSignalMax = 1023;
// Range of a temperature sensor.  The error of a noisy sensor is a percentage of its range.  The
// number is our choice.
constexpr double kTemperatureRangeMicroC = 100e6;
constexpr double kRayMaxM = 2.0;
// Least light that a distance sensor needs to see a thing.  The light that comes back is the
// reflectance of the thing, divided by the square of its distance.  The data sheets promise that
// such a sensor sees grey paper, with a reflectance of 0.18, up to 0.8 m (docs/calibration.md).
constexpr double kLightMinPerM2 = 0.18 / (0.8 * 0.8);

// Time for which an ERS-7 measures one of its two distance sensors in the head before it changes to
// the other distance sensor (field-notes.md 8.5).
constexpr int64_t kTurnUs = 50'000;
// Values of the field `signal` in the sample of a distance sensor.  An ERS-7 measures its two
// distance sensors in the head in turn.  kFreshSignal: the value is new.  kKeptSignal: the value
// was kept while the other sensor was measured.  No document gives these numbers, so they are our
// choice.
constexpr word kFreshSignal = 1, kKeptSignal = 0;

int TurnOf(int64_t frame) { return static_cast<int>(frame * kFrameUs / kTurnUs % 2); }

// Converts `value` to millionths and rounds it, halves away from zero, with the same result on
// every machine.
slongword ToMicro(double value) {
  const double scaled = value * kMicro;
  return static_cast<slongword>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
}

// Returns the output of the 10-bit A/D converter for an angle in `range`, the range between the
// mechanical stops.
word SignalOf(double angle_rad, const Range& range) {
  const double part = (angle_rad - range.min) / (range.max - range.min);
  return static_cast<word>(std::clamp(part, 0.0, 1.0) * kSignalMax + 0.5);
}

ODataType TypeOf(SensorKind kind) {
  switch (kind) {
    case SensorKind::kJoint:
      return odataJOINT_VALUE;
    case SensorKind::kForce:
      return odataFORCE;
    case SensorKind::kDistance:
      return odataLENGTH;
    case SensorKind::kSwitch:
      return odataSWITCH;
    case SensorKind::kTemperature:
      return odataTEMPERATURE;
    case SensorKind::kAcceleration:
      return odataACCELERATION;
    case SensorKind::kRaw:
      return odataNO_DIMENSION;
  }
  return odataUNDEF;
}

slongword Clamped(const Sensor& sensor, slongword value) {
  if (!sensor.has_range) return value;
  return static_cast<slongword>(std::clamp<int64_t>(value, sensor.min, sensor.max));
}

}  // namespace

SensorSource::SensorSource(const RobotModel& model, const PrimitiveTable& primitives, Rng noise,
                           Rng fault_noise)
    : model_(model),
      primitives_(primitives),
      noise_(noise),
      fault_noise_(fault_noise),
      latest_(model.sensors.size()),
      readings_(model.joints.size()),
      held_(model.sensors.size()),
      frames_(model.sensors.size() * kFramesPerVector) {
  // Sets all bytes of the samples to 0, also their padding, because the state hash of the run
  // includes all bytes.
  std::memset(static_cast<void*>(latest_.data()), 0, latest_.size() * sizeof latest_[0]);
  std::memset(static_cast<void*>(frames_.data()), 0, frames_.size() * sizeof frames_[0]);
}

// Takes the sample of a joint's sensor.  Keeps the last sample if the angle, the drive, the set
// point and the state of the sensor have not changed since then.
void SensorSource::SampleJoint(size_t index, int joint, const BodyState& state,
                               const Devices& devices) {
  const auto j = static_cast<size_t>(joint);
  const JointState& now = state.joints[j];
  const slongword target_urad = devices.joints[j].target_urad;
  const JointDisturbance* const disturbance = devices.DisturbanceOf(joint);
  const double angle_rad =
      disturbance == nullptr ? now.angle_rad : disturbance->Measured(now.angle_rad);
  const bool is_dead = disturbance != nullptr && disturbance->is_sensor_dead;
  JointReading& before = readings_[j];
  const JointReading reading = {angle_rad, now.drive, target_urad, is_dead};
  if (before == reading) return;
  before = reading;
  const Range& stops_rad = model_.joints[j].hard_rad;
  OJointValue value;
  std::memset(static_cast<void*>(&value), 0, sizeof value);
  value.value = ToMicro(angle_rad);
  value.signal = is_dead ? osensorframeINVALID_SIGNAL : SignalOf(angle_rad, stops_rad);
  value.pwmDuty = static_cast<sword>(std::clamp(now.drive, -32768.0, 32767.0));
  value.refValue = target_urad;
  value.refSignal = SignalOf(target_urad / kMicro, stops_rad);
  static_assert(sizeof latest_[index] == sizeof value);
  std::memcpy(static_cast<void*>(&latest_[index]), &value, sizeof value);
}

// Returns the sample of a distance sensor.  Converts the distance of the thing in front of the
// sensor by linear interpolation in the model's table, and adds uniform noise.
slongword SensorSource::DistanceOf(const Sensor& sensor, const Body& body) {
  if (sensor.body < 0 || sensor.lookup.size() < 2) return static_cast<slongword>(sensor.max);
  const Eigen::Isometry3d X_WP = body.PoseOf(static_cast<size_t>(sensor.body));
  const RayHit hit =
      body.CastRay(X_WP * sensor.place_m, X_WP.linear() * sensor.direction, kRayMaxM);
  // The distance sensor measures an angle and not the strength of the light, so it gives the same
  // distance for a dark and a bright thing, as long as it sees the thing at all.
  const bool is_seen = hit.reflectance >= kLightMinPerM2 * hit.distance_m * hit.distance_m;
  const double distance = is_seen ? hit.distance_m : kRayMaxM;
  const auto& table = sensor.lookup;
  size_t i = 1;
  while (i + 1 < table.size() && distance > table[i].distance_m) ++i;
  const DistanceRow& a = table[i - 1];
  const DistanceRow& b = table[i];
  const double part =
      std::clamp((distance - a.distance_m) / (b.distance_m - a.distance_m), 0.0, 1.0);
  const double value = a.value_m + part * (b.value_m - a.value_m);
  const double noise = a.noise + part * (b.noise - a.noise);
  return ToMicro(value * (1.0 + noise * (2.0 * noise_.NextDouble() - 1.0)));
}

// Returns whether the floor or a thing presses the switch of paw `paw`.
bool SensorSource::IsPressed(const BodyState& state, size_t paw) const {
  if (!state.paws[paw]) return false;
  return state.paw_forces_n.empty() || state.paw_forces_n[paw] >= model_.paw_force_n;
}

// Returns the value that a sensor measures when no person's hand touches it.  REQUIRES: the sensor
// does not belong to a joint.
slongword SensorSource::ValueOf(const Sensor& sensor, const Body& body) {
  switch (sensor.kind) {
    case SensorKind::kDistance:
      return Clamped(sensor, DistanceOf(sensor, body));
    case SensorKind::kSwitch:
      return sensor.paw >= 0 && IsPressed(body.state(), static_cast<size_t>(sensor.paw)) ? oswitchON
                                                                                         : 0;
    case SensorKind::kAcceleration:
      return Clamped(sensor, ToMicro(body.state().gravity_B.dot(sensor.direction)));
    case SensorKind::kTemperature:
      return body_c_ * static_cast<slongword>(kMicro);
    default:
      return 0;  // touch sensors are 0 unless a hand presses them
  }
}

void SensorSource::SampleTurn(int turn, const Body& body, const Devices& devices) {
  has_sample_ = true;
  const BodyState& state = body.state();
  for (size_t i = 0; i < latest_.size(); ++i) {
    const Sensor& sensor = model_.sensors[i];
    if (sensor.kind == SensorKind::kJoint && sensor.joint >= 0) {
      SampleJoint(i, sensor.joint, state, devices);
      continue;
    }
    // Always computes the value, because the computation takes random numbers: without it, the
    // noise of the other sensors would change.  The value is not used if an input sets the value of
    // the sensor (held_), or if it is not the sensor's turn.
    const slongword value = ValueOf(sensor, body);
    const slongword before = latest_[i].value;
    const bool is_kept = sensor.turn >= 0 && turn != kAllTurns && turn != sensor.turn;
    latest_[i].value = held_[i].value_or(is_kept ? before : value);
    if (sensor.turn >= 0) latest_[i].signal = is_kept ? kKeptSignal : kFreshSignal;
    const auto fault = faults_.find(static_cast<int>(i));
    if (fault == faults_.end()) continue;
    // Adds no noise if the sensor kept its value while the other sensor was measured, because the
    // noise was added already when the value was measured.
    if (is_kept && fault->second.kind == SensorFaultKind::kNoisy) continue;
    ApplyFault(fault->second, sensor, before, &latest_[i]);
  }
}

// Changes the new sample `value` of a sensor by the sensor's fault.  `before` is the value of the
// sample of the frame before.
void SensorSource::ApplyFault(const SensorFault& fault, const Sensor& sensor, slongword before,
                              OSensorValue* value) {
  switch (fault.kind) {
    case SensorFaultKind::kStuck:
      value->value = before;
      break;
    case SensorFaultKind::kDead:
      value->value = opsdINVALID_VALUE;
      value->signal = osensorframeINVALID_SIGNAL;
      break;
    case SensorFaultKind::kNoisy: {
      const double noise = FaultNoise();
      const double share = fault.percent / 100.0;
      // Adds no error to the value of a switch, but inverts it at random, because a switch has only
      // two values.
      if (sensor.kind == SensorKind::kSwitch) {
        if (std::fabs(noise) < share) value->value = value->value == oswitchON ? 0 : oswitchON;
        break;
      }
      const double range =
          sensor.has_range ? static_cast<double>(sensor.max - sensor.min) : kTemperatureRangeMicroC;
      value->value = Clamped(sensor, value->value + static_cast<slongword>(noise * share * range));
      break;
    }
  }
}

void SensorSource::Hold(int sensor, slongword value) {
  ASSERT(model_.sensors[static_cast<size_t>(sensor)].joint < 0, "sensor {} is a joint's", sensor);
  held_[static_cast<size_t>(sensor)] = value;
}

void SensorSource::Break(int sensor, const SensorFault& fault) {
  ASSERT(model_.sensors[static_cast<size_t>(sensor)].joint < 0, "sensor {} is a joint's", sensor);
  faults_[sensor] = fault;
}

void SensorSource::Repair(int sensor) {
  faults_.erase(sensor);
  latest_[static_cast<size_t>(sensor)].signal = 0;
}

bool SensorSource::Sample(int64_t frame, const Body& body, const Devices& devices) {
  ASSERT(collected_ >= 0 && collected_ < kFramesPerVector, "{} frames", collected_);
  if (collected_ == 0) first_frame_ = frame;
  // The first sample measures all sensors, because no sensor has an earlier value yet that it could
  // keep.
  SampleTurn(has_sample_ ? TurnOf(frame) : kAllTurns, body, devices);
  std::copy(latest_.begin(), latest_.end(),
            frames_.begin() + static_cast<ptrdiff_t>(latest_.size()) * collected_);
  if (++collected_ < kFramesPerVector) return false;
  collected_ = 0;
  return true;
}

RCRegion* SensorSource::FreeVector() {
  if (RCRegion* const free = pool_.FindFree()) return free;
  const size_t count = latest_.size();
  constexpr size_t kInfo = sizeof(OSensorFrameInfo);
  constexpr size_t kData = sizeof(OSensorFrameData);
  RCRegion* const region = NewVectorRegion(odataSENSOR_FRAME_VECTOR, kInfo, count, count * kData);
  // Writes the info structs of the vector's elements only when the region is made, because they are
  // the same in all vectors.
  auto* const vector = reinterpret_cast<OSensorFrameVectorData*>(region->Base());
  for (size_t i = 0; i < count; ++i) {
    OSensorFrameInfo& info = *vector->GetInfo(static_cast<int>(i));
    info.type = TypeOf(model_.sensors[i].kind);
    info.primitiveID = primitives_.IdOfSensor(static_cast<int>(i));
    info.numFrames = kFramesPerVector;
    info.frameSize = sizeof(OSensorValue);
    info.dataOffset = static_cast<longword>(sizeof(ODataVectorInfo) + count * kInfo + i * kData);
    info.dataSize = kData;
  }
  pool_.Add(region);
  return region;
}

RCRegion* SensorSource::MakeVector(const OptionalBytes& optional) {
  ASSERT(collected_ == 0, "{} frames of the next vector are in place", collected_);
  RCRegion* const region = FreeVector();
  auto* const vector = reinterpret_cast<OSensorFrameVectorData*>(region->Base());
  optional.Put(&vector->vectorInfo);
  const size_t count = latest_.size();
  for (size_t i = 0; i < count; ++i) {
    vector->GetInfo(static_cast<int>(i))->frameNumber = FrameNumber(first_frame_);
    OSensorFrameData& data = *vector->GetData(static_cast<int>(i));
    for (size_t f = 0; f < kFramesPerVector; ++f) data.frame[f] = frames_[f * count + i];
  }
  return region;
}

void SensorSource::SwitchOff() {
  std::memset(static_cast<void*>(frames_.data()), 0, frames_.size() * sizeof frames_[0]);
  first_frame_ = 0;
  collected_ = 0;
  has_sample_ = false;
  pool_.Clear();
}

void SensorSource::HashState(Hasher* hasher) const {
  noise_.HashState(hasher);
  hasher->Add(first_frame_);
  hasher->Add(collected_);
  hasher->AddBytes(latest_.data(), latest_.size() * sizeof latest_[0]);
  hasher->AddBytes(frames_.data(), frames_.size() * sizeof frames_[0]);
  for (size_t i = 0; i < held_.size(); ++i) {
    if (!held_[i]) continue;
    hasher->Add(static_cast<uint64_t>(i));
    hasher->Add(*held_[i]);
  }
  if (is_fault_noise_used_) fault_noise_.HashState(hasher);
  for (const auto& [sensor, fault] : faults_) {
    hasher->Add(sensor);
    hasher->Add(fault.kind);
    hasher->Add(fault.percent);
  }
}

}  // namespace openr_host
