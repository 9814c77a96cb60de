// A robot as plain data: parts, joints, limits, gains, sensors, lights, postures.
//
// The numbers are in model/*.json, where each table names its source.  Units here are SI and
// radians; the files use mm, g and degrees.  All places, axes and box centres are given in the base
// frame B with all joints at 0.  In this pose the frame of every part coincides with B
// (docs/body.md).  A locator is the name by which OPEN-R finds a part of the robot, for example
// "PRM:/r2/c1-Joint2:j1".
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// Gains of a servo: the parameters of OPENR::SetJointGain().  A gain with a shift acts like gain *
// 2^(shift - 16) (robot.md, section 8).
struct PidGains {
  uint16_t p = 0, i = 0, d = 0;
  uint16_t p_shift = 0, i_shift = 0, d_shift = 0;
  bool operator==(const PidGains&) const = default;
};

struct Range {
  double min = 0;
  double max = 0;  // end of the range, >= min
};

// A rigid part of a robot.  Part 0 is the trunk, whose frame is B.  Every other part is the child
// of exactly one joint, and a parent comes before its children.
struct BodyPart {
  std::string name;
  double mass_kg = 0;    // mass of the part, >= 0; the body with physics requires > 0
  bool has_box = false;  // false: the shape is not known, so the robot can have no physics
  Eigen::Vector3d size_m{0, 0, 0};    // size of the box along x, y, z of B with all joints at 0
  Eigen::Vector3d centre_m{0, 0, 0};  // centre of mass, which is also the centre of the box
  int joint = -1;                     // index of the joint that moves the part; -1 for the trunk
};

// The ball at the end of a leg.  The ball belongs to part `body` and has no mass of its own.
struct Paw {
  std::string leg;  // name of the leg: "LF", "LH", "RF" or "RH"
  int body = -1;
  Eigen::Vector3d centre_m{0, 0, 0};
  double radius_m = 0;
  int sensor = -1;  // index of the switch under the paw in RobotModel::sensors
};

// A motor with its hinge.  The angle of the joint is the right-handed rotation of part `child`
// about `axis`; it equals the joint value of OPEN-R.
struct JointModel {
  std::string name;     // name of the joint, such as "LF_j1"
  std::string locator;  // locator, such as "PRM:/r2/c1-Joint2:j1"
  int parent = -1;
  int child = -1;
  Eigen::Vector3d axis{0, 0, 0};  // unit vector along a coordinate axis of B, in either direction
  Eigen::Vector3d anchor_m{0, 0, 0};
  Range soft_rad;              // software limits of the angle, for set points
  Range hard_rad;              // mechanical stops: the limits that the joint cannot pass
  Range speed_rad_s;           // lowest and highest speed of planned movements
  PidGains gains;              // the standard gains of the vendor
  double stall_torque_nm = 0;  // torque at full drive and speed 0, in N m; 0: not known
  int sensor = -1;             // index of the joint's sensor in RobotModel::sensors
  // Index of the joint's angle in the key frames (postures) of motion files; -1 when motion files
  // do not have this joint.
  int mtn = -1;
};

struct Led {
  std::string name;
  std::string locator;
  std::string type;      // type of the light: "LED2" or "LED3"
  std::string colour;    // colour of the light; "": not known
  std::string colour_b;  // colour in mode B of the face lights of the ERS-7; "": same as `colour`
};

// An ear.  The plunger, the actuator that moves it, has two positions, on and off, and no sensor.
struct Plunger {
  std::string name;
  std::string locator;
  std::string type;  // type of the plunger: "Joint3" or "Joint4"
  double on_rad = 0;
  double off_rad = 0;
  int settle_ms = 128;
  Eigen::Vector3d place_m{0, 0, 0};
  int mtn = -1;
};

enum class SensorKind { kJoint, kForce, kDistance, kSwitch, kTemperature, kAcceleration, kRaw };

// Returns the SI unit of sensors of this kind, such as "m/s^2"; OPEN-R gives their values in
// millionths of it.  Returns "" for switches and for plain numbers, which OPEN-R gives as they are.
const char* SiUnitOf(SensorKind kind);

// A row of a distance sensor's table: at `distance_m` the sensor measures `value_m`, plus or minus
// noise * value_m.
struct DistanceRow {
  double distance_m = 0;
  double value_m = 0;
  double noise = 0;
};

// A sensor.  Its index in RobotModel::sensors is also the index of its element in sensor vectors.
struct Sensor {
  std::string name;
  // Name of the sensor in inputs and tests, such as "chin"; "" for the sensor of a joint, which is
  // found by the joint's name.
  std::string short_name;
  std::string locator;
  SensorKind kind = SensorKind::kRaw;
  bool has_range = false;
  int64_t min = 0, max = 0;  // limits in the sensor's OPEN-R unit (10^-6 rad, N, m, m/s^2; 0 or 1)
  int joint = -1;            // index of the joint that a sensor of kind kJoint measures; else -1
  int paw = -1;              // index in RobotModel::paws of the paw with this switch; -1: no paw
  int body = -1;             // index of the part with a sensor of kind kDistance; -1: not known
  Eigen::Vector3d place_m{0, 0, 0};
  // Unit vector: the direction of the ray of a sensor of kind kDistance or, in the base frame B, of
  // the axis that a sensor of kind kAcceleration measures.
  Eigen::Vector3d direction{0, 0, 0};
  // Table by which a sensor of kind kDistance converts the distance of a thing to its value: at
  // least two rows, in rising order of distance_m.
  std::vector<DistanceRow> lookup;
  // For one of two sensors that are measured in turn (the distance sensors of an ERS-7): its
  // number, 0 or 1.  For a sensor that is measured in every frame: -1.
  int turn = -1;
};

struct Camera {
  std::string locator;
  int body = -1;
  Eigen::Vector3d place_m{0, 0, 0};
  Eigen::Vector3d direction{1, 0, 0};
  int width_px = 0, height_px = 0;
  double frames_per_s = 0;
  double fov_h_rad = 0, fov_v_rad = 0;
};

struct Posture {
  std::string name;
  std::vector<double> angles_rad;  // angles of the joints, in the order of RobotModel::joints
};

// Limits at which a robot protects itself and shuts down; 0: the robot has no such limit.
struct Limits {
  int hot_c = 0;  // highest temperature of the battery while it discharges, in degrees Celsius
  int hot_charging_c = 0;  // highest temperature of the battery while it is charged
  int current_ma = 0;      // highest mean current of the battery over about 100 ms
  int jam_frames = 0;      // number of frames of 8 ms for which a joint may be jammed
};

struct RobotModel {
  std::string name;                     // name of the model, such as "ERS-210"
  std::string design;                   // result of OPENR::GetRobotDesign()
  std::vector<std::string> mtn_labels;  // design labels of the motion files that fit this robot
  std::vector<BodyPart> bodies;
  std::vector<Paw> paws;
  double paw_force_n = 0;  // least force, in N, that turns the switch of a paw on
  std::vector<JointModel> joints;
  double accel_min_rad_s2 = 0, accel_default_rad_s2 = 0, accel_max_rad_s2 = 0;
  std::vector<Led> leds;
  std::vector<Plunger> plungers;
  std::vector<Sensor> sensors;
  Camera camera;
  std::string speaker_locator;
  std::string microphone_locator;
  int microphone_frames = 0;  // number of frames of 8 ms in one sound vector
  Limits protection;
  std::vector<Posture> postures;
  uint64_t content_hash = 0;  // hash of the text of the model file

  // The next functions return the index of the part, joint or sensor with this name or locator; -1
  // when the model has no such element.
  int FindBody(std::string_view body_name) const;
  int FindJoint(std::string_view joint_name) const;
  int FindJointByLocator(std::string_view locator) const;
  int FindSensorByLocator(std::string_view locator) const;

  // Returns the sensors that `name` names: the sensor with this short name, name or locator, or all
  // sensors whose short names begin with `name` and an underscore ("head" is head_front and
  // head_back).  Upper and lower case count as equal.  Sensors of joints have the names of their
  // joints.
  std::vector<int> SensorsNamed(std::string_view name) const;

  // Returns the joint with this name or locator, or with the name of its sensor, in capitals or
  // small letters; -1 when the model has no such joint.
  int JointNamed(std::string_view name) const;

  // Returns the angles of the posture with this name, in radians.  When the model has no such
  // posture, throws std::runtime_error with the names of all postures.
  const std::vector<double>& PostureAngles(std::string_view posture_name) const;

  double TotalMassKg() const;
};

// Reads a model file (model/*.json).  Throws std::runtime_error with file, place and value when the
// file cannot be read or describes an impossible robot.
RobotModel LoadRobotModel(const std::string& path);

// Reads a model from `text`, the text of a model file.  Error messages call this file `file_name`.
RobotModel ParseRobotModel(const std::string& text, const std::string& file_name);

}  // namespace openr_host
