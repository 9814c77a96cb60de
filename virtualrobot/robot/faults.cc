#include "virtualrobot/robot/faults.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <map>
#include <set>
#include <utility>

#include "runtime/base/hasher.h"
#include "runtime/base/spelling.h"
#include "runtime/core/system.h"
#include "virtualrobot/base/input_words.h"
#include "virtualrobot/robot/robot_parts.h"

namespace openr_host {
namespace {

constexpr const char* kKindNames[] = {"jammed", "weak", "unpowered", "stuck", "noisy", "dead"};
constexpr char kMissingName[] = "missing";
constexpr int kHeatMinC = -20, kHeatMaxC = 120;
constexpr int kDrawMaxMa = 30'000;

// Reads a whole number from `min` to `max`.  Returns "" or the error.
std::string ReadWhole(std::string_view text, int min, int max, int* number) {
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, *number);
  if (error != std::errc() || at != end || *number < min || *number > max)
    return fmt::format("'{}' is no whole number from {} to {}", text, min, max);
  return "";
}

// Returns the limb of a primitive, the beginning of its locator: "PRM:/r2" for each joint of the
// left fore leg.
std::string LimbOf(const std::string& locator) {
  const size_t root = locator.find('/');
  return root == std::string::npos ? locator
                                   : locator.substr(0, locator.find_first_of("/-", root + 1));
}

}  // namespace

std::vector<std::string> Faults::Names() {
  std::vector<std::string> names(std::begin(kKindNames), std::end(kKindNames));
  names.push_back(kMissingName);
  return names;
}

void Faults::AddInputs() {
  const auto add = [this](const char* name, const char* usage, const char* help,
                          std::string (Faults::*read)(std::string_view, Inputs::Action*)) {
    robot_.system.inputs().AddKind(
        robot_.robot_index,
        {name, usage, help, [this, read](int, std::string_view rest, Inputs::Action* action) {
           const std::string problem = (this->*read)(rest, action);
           // Makes inputs of time 0 act before the boot.  Objects open most primitives in DoInit,
           // so a part that is missing at time 0 must be missing before DoInit.  All inputs of
           // faults act before the boot, not only those for missing parts, so that they take effect
           // in the order of their lines, and a repair ends the faults above it.
           action->is_before_boot = true;
           return problem;
         }});
  };
  add("break", "break JOINT|SENSOR|LOCATOR FAULT [for DURATION]",
      "Makes a part faulty.  FAULT: jammed, weak N%, unpowered (joints); stuck, noisy N%, dead "
      "(sensors, also those of joints); missing (any part, lights and the camera by their "
      "locators): OpenPrimitive() fails.",
      &Faults::ReadBreak);
  add("repair", "repair JOINT|SENSOR|LOCATOR|body|battery|all", "Ends break, heat and draw.",
      &Faults::ReadRepair);
  add("heat", "heat body|battery DEGREES [for DURATION]",
      "Keeps a temperature in degrees Celsius, until it is repaired.", &Faults::ReadHeat);
  add("draw", "draw MILLIAMPERES [for DURATION]",
      "Draws a current from the battery, beside the robot's own, until the battery is repaired.",
      &Faults::ReadDraw);
}

std::string Faults::FindSensors(const std::string& name, std::vector<int>* sensors) const {
  const RobotModel& model = robot_.model;
  *sensors = model.SensorsNamed(name);
  if (!sensors->empty()) return "";
  std::vector<std::string> known;
  for (const Sensor& sensor : model.sensors) {
    known.push_back(sensor.joint < 0 ? sensor.short_name
                                     : model.joints[static_cast<size_t>(sensor.joint)].name);
  }
  return fmt::format("the {} has no joint or sensor '{}'{}; it has {}", model.name, name,
                     DidYouMean(name, known), fmt::join(known, ", "));
}

std::string Faults::FindPrimitives(const std::string& name, std::vector<OPrimitiveID>* ids) const {
  ids->clear();
  if (const OPrimitiveID id = robot_.primitives.IdOf(name); id != oprimitiveID_UNDEF) {
    ids->push_back(id);
    return "";
  }
  std::vector<int> sensors;
  std::string problem = FindSensors(name, &sensors);
  for (const int sensor : sensors) ids->push_back(robot_.primitives.IdOfSensor(sensor));
  return problem;
}

std::optional<Faults::Place> Faults::PlaceOf(Kind kind, int sensor) const {
  // Gives a fault of kind kStuck, or of a kind declared after it, to the sensor itself.  The kinds
  // before kStuck are faults of a motor, so they need a sensor that belongs to a joint.
  if (kind >= Kind::kStuck) return Place{Part::kSensor, sensor};
  const int joint = robot_.model.sensors[static_cast<size_t>(sensor)].joint;
  if (joint < 0) return {};
  return Place{Part::kMotor, joint};
}

std::string Faults::ReadBreak(std::string_view rest, Inputs::Action* action) {
  std::vector<std::string> words = SplitInput(rest);
  Fault fault{Kind::kJammed, 0, {}};
  if (std::string problem = TakeForDuration(&words, &fault.frames); !problem.empty())
    return problem;
  if (words.size() < 2) return "needs a joint, a sensor or a locator, and a fault";
  if (words[1] == kMissingName) return ReadMissing(words, fault, action);
  size_t kind = 0;
  while (kind < std::size(kKindNames) && words[1] != kKindNames[kind]) ++kind;
  if (kind == std::size(kKindNames)) {
    const std::vector<std::string> known = Names();
    return fmt::format("'{}' is no fault{}; known are {}", words[1], DidYouMean(words[1], known),
                       fmt::join(known, ", "));
  }
  // `kind`, an index of kKindNames, is also the number of a Kind, because kKindNames has the names
  // of the first kinds in the order of Kind.
  fault.kind = static_cast<Kind>(kind);
  const bool has_percent = fault.kind == Kind::kWeak || fault.kind == Kind::kNoisy;
  if (words.size() != (has_percent ? 3u : 2u))
    return fmt::format("{} needs {}", words[1], has_percent ? "one percentage" : "nothing more");
  if (has_percent) {
    if (std::string problem = ReadPercent(words[2], &fault.amount); !problem.empty())
      return problem;
  }
  std::vector<int> sensors;
  if (std::string problem = FindSensors(words[0], &sensors); !problem.empty()) return problem;
  std::vector<Place> places;
  for (const int sensor : sensors) {
    const std::optional<Place> place = PlaceOf(fault.kind, sensor);
    if (!place)
      return fmt::format("'{}' is a sensor and no joint; it can be stuck, noisy N% or dead",
                         words[0]);
    places.push_back(*place);
  }
  *action = [this, places, fault] {
    for (const Place& place : places) Begin(place, fault);
  };
  return "";
}

std::string Faults::ReadMissing(const std::vector<std::string>& words, const Fault& fault,
                                Inputs::Action* action) {
  if (words.size() != 2) return fmt::format("{} needs nothing more", kMissingName);
  std::vector<OPrimitiveID> ids;
  if (std::string problem = FindPrimitives(words[0], &ids); !problem.empty()) return problem;
  *action = [this, ids, frames = fault.frames] {
    for (const OPrimitiveID id : ids)
      Begin({Part::kPrimitive, static_cast<int>(id)}, {Kind::kMissing, 0, frames});
  };
  return "";
}

void Faults::ReportMissingLimbs() const {
  std::vector<std::string> limbs;                         // all limbs, in the order of the model
  std::map<std::string, std::vector<std::string>> names;  // for each limb, the names of its joints
  std::set<std::string> left;                             // limbs with a joint that is not missing
  for (const JointModel& joint : robot_.model.joints) {
    const std::string limb = LimbOf(joint.locator);
    if (names[limb].empty()) limbs.push_back(limb);
    names[limb].push_back(joint.name);
    if (!robot_.primitives.Find(robot_.primitives.IdOf(joint.locator))->is_missing)
      left.insert(limb);
  }
  for (const std::string& limb : limbs) {
    if (left.contains(limb)) continue;
    robot_.system.AddFindingAboutRobot(
        robot_.robot_index, Severity::kError,
        fmt::format("all joints of {} are missing ({}): the robot's boot ends with 'DR OPEN-R SDK "
                    "version can run odrexecMODE3 only' and OPENR::Fatal(-1), as with a limb of "
                    "another model or a bad contact (field-notes.md 5.3); here it goes on",
                    limb, fmt::join(names[limb], ", ")));
  }
}

std::string Faults::ReadHeat(std::string_view rest, Inputs::Action* action) {
  std::vector<std::string> words = SplitInput(rest);
  Fault fault{Kind::kHot, 0, {}};
  if (std::string problem = TakeForDuration(&words, &fault.frames); !problem.empty())
    return problem;
  if (words.size() != 2 || (words[0] != "body" && words[0] != "battery"))
    return "needs body or battery and one temperature";
  if (std::string problem = ReadWhole(words[1], kHeatMinC, kHeatMaxC, &fault.amount);
      !problem.empty())
    return problem;
  const Place place{words[0] == "body" ? Part::kBody : Part::kBattery};
  *action = [this, place, fault] { Begin(place, fault); };
  return "";
}

std::string Faults::ReadDraw(std::string_view rest, Inputs::Action* action) {
  std::vector<std::string> words = SplitInput(rest);
  Fault fault{Kind::kDraw, 0, {}};
  if (std::string problem = TakeForDuration(&words, &fault.frames); !problem.empty())
    return problem;
  if (words.size() != 1) return "needs one current in mA";
  if (std::string problem = ReadWhole(words[0], 1, kDrawMaxMa, &fault.amount); !problem.empty())
    return problem;
  *action = [this, fault] { Begin({Part::kSupply}, fault); };
  return "";
}

std::string Faults::ReadRepair(std::string_view rest, Inputs::Action* action) {
  const std::vector<std::string> words = SplitInput(rest);
  if (words.size() != 1) return "needs one joint, sensor or locator, body, battery or all";
  std::vector<Place> places;
  if (words[0] == "body") {
    places = {{Part::kBody}};
  } else if (words[0] == "battery") {
    places = {{Part::kBattery}, {Part::kSupply}};
  } else if (words[0] != "all") {
    std::vector<OPrimitiveID> ids;
    if (std::string problem = FindPrimitives(words[0], &ids); !problem.empty()) return problem;
    for (const OPrimitiveID id : ids) {
      places.push_back({Part::kPrimitive, static_cast<int>(id)});
      const int sensor = robot_.primitives.Find(id)->sensor;
      if (sensor < 0) continue;
      places.push_back({Part::kSensor, sensor});
      const int joint = robot_.model.sensors[static_cast<size_t>(sensor)].joint;
      if (joint >= 0) places.push_back({Part::kMotor, joint});
    }
  }
  *action = [this, places] {
    std::vector<Place> ending = places;
    if (ending.empty()) {  // the text is "all": ends all faults
      for (const auto& [place, fault] : faults_) ending.push_back(place);
    }
    for (const Place& place : ending) End(place);
  };
  return "";
}

void Faults::Begin(const Place& place, const Fault& fault) {
  End(place);  // ends an earlier fault at this place, because a place has one fault at a time
  faults_[place] = fault;
  const double share = fault.amount / 100.0;
  switch (place.part) {
    case Part::kMotor: {
      JointDisturbance& disturbance = robot_.devices.Disturbance(place.number);
      if (fault.kind == Kind::kWeak) disturbance.strength = share;
      if (fault.kind == Kind::kUnpowered) disturbance.strength = 0;
      if (fault.kind == Kind::kJammed)
        disturbance.jammed_rad =
            robot_.body->state().joints[static_cast<size_t>(place.number)].angle_rad;
      break;
    }
    case Part::kSensor: {
      const int joint = robot_.model.sensors[static_cast<size_t>(place.number)].joint;
      if (joint < 0) {
        const auto kind = fault.kind == Kind::kStuck   ? SensorFaultKind::kStuck
                          : fault.kind == Kind::kNoisy ? SensorFaultKind::kNoisy
                                                       : SensorFaultKind::kDead;
        robot_.sensors.Break(place.number, {kind, fault.amount});
        break;
      }
      JointDisturbance& disturbance = robot_.devices.Disturbance(joint);
      if (fault.kind == Kind::kStuck)
        disturbance.sensed_rad = robot_.body->state().joints[static_cast<size_t>(joint)].angle_rad;
      if (fault.kind == Kind::kDead) disturbance.sensed_rad = 0;
      disturbance.is_sensor_dead = fault.kind == Kind::kDead;
      break;
    }
    case Part::kBody:
      robot_.energy.Keep(HeatedPart::kBody, fault.amount);
      break;
    case Part::kBattery:
      robot_.energy.Keep(HeatedPart::kBattery, fault.amount);
      break;
    case Part::kSupply:
      robot_.energy.SetExtraMa(fault.amount);
      break;
    case Part::kPrimitive:
      robot_.primitives.Find(static_cast<OPrimitiveID>(place.number))->is_missing = true;
      break;
  }
}

void Faults::End(const Place& place) {
  if (faults_.erase(place) == 0) return;
  switch (place.part) {
    case Part::kMotor: {
      JointDisturbance& disturbance = robot_.devices.Disturbance(place.number);
      disturbance.strength = 1;
      disturbance.jammed_rad.reset();
      break;
    }
    case Part::kSensor: {
      const int joint = robot_.model.sensors[static_cast<size_t>(place.number)].joint;
      if (joint < 0) {
        robot_.sensors.Repair(place.number);
        break;
      }
      JointDisturbance& disturbance = robot_.devices.Disturbance(joint);
      disturbance.sensed_rad.reset();
      disturbance.sensor_error_rad = 0;
      disturbance.is_sensor_dead = false;
      break;
    }
    case Part::kBody:
      robot_.energy.Keep(HeatedPart::kBody, {});
      break;
    case Part::kBattery:
      robot_.energy.Keep(HeatedPart::kBattery, {});
      break;
    case Part::kSupply:
      robot_.energy.SetExtraMa(0);
      break;
    case Part::kPrimitive:
      robot_.primitives.Find(static_cast<OPrimitiveID>(place.number))->is_missing = false;
      break;
  }
}

void Faults::DoFrame() {
  for (auto at = faults_.begin(); at != faults_.end();) {
    const Place place = at->first;
    Fault& fault = at->second;
    ++at;  // advances `at` before End() erases this element
    if (fault.frames && (*fault.frames)-- == 0) {
      End(place);
      continue;
    }
    if (fault.kind != Kind::kNoisy) continue;
    const int joint = robot_.model.sensors[static_cast<size_t>(place.number)].joint;
    if (joint < 0) continue;
    const Range& stops_rad = robot_.model.joints[static_cast<size_t>(joint)].hard_rad;
    robot_.devices.Disturbance(joint).sensor_error_rad =
        robot_.sensors.FaultNoise() * fault.amount / 100 * (stops_rad.max - stops_rad.min);
  }
}

std::string Faults::NameOf(const Place& place) const {
  switch (place.part) {
    case Part::kMotor:
      return robot_.model.joints[static_cast<size_t>(place.number)].name;
    case Part::kSensor: {
      const Sensor& sensor = robot_.model.sensors[static_cast<size_t>(place.number)];
      if (sensor.joint < 0) return sensor.short_name;
      return robot_.model.joints[static_cast<size_t>(sensor.joint)].name;
    }
    case Part::kPrimitive: {
      const auto id = static_cast<OPrimitiveID>(place.number);
      const Primitive& primitive = *robot_.primitives.Find(id);
      if (primitive.sensor < 0) return primitive.locator;
      return NameOf({Part::kSensor, primitive.sensor});
    }
    case Part::kBody:
      return "body";
    default:
      return "battery";
  }
}

std::vector<std::string> Faults::Present() const {
  std::vector<std::string> texts;
  for (const auto& [place, fault] : faults_) {
    const std::string name = NameOf(place);
    if (fault.kind == Kind::kHot) {
      texts.push_back(fmt::format("{} at {} degrees Celsius", name, fault.amount));
    } else if (fault.kind == Kind::kDraw) {
      texts.push_back(fmt::format("{} gives {} mA more", name, fault.amount));
    } else if (fault.kind == Kind::kMissing) {
      texts.push_back(fmt::format("{} {}", name, kMissingName));
    } else {
      const bool has_percent = fault.kind == Kind::kWeak || fault.kind == Kind::kNoisy;
      texts.push_back(fmt::format("{} {}{}", name, kKindNames[static_cast<size_t>(fault.kind)],
                                  has_percent ? fmt::format(" {}%", fault.amount) : ""));
    }
  }
  return texts;
}

void Faults::HashState(Hasher* hasher) const {
  for (const auto& [place, fault] : faults_) {
    hasher->Add(place.part);
    hasher->Add(place.number);
    hasher->Add(fault.kind);
    hasher->Add(fault.amount);
    hasher->Add(fault.frames.value_or(-1));
    int joint = -1;
    if (place.part == Part::kMotor) joint = place.number;
    if (place.part == Part::kSensor)
      joint = robot_.model.sensors[static_cast<size_t>(place.number)].joint;
    const JointDisturbance* const disturbance =
        joint < 0 ? nullptr : robot_.devices.DisturbanceOf(joint);
    if (disturbance == nullptr) continue;
    hasher->Add(disturbance->jammed_rad.value_or(0));
    hasher->Add(disturbance->sensed_rad.value_or(0));
    hasher->Add(disturbance->sensor_error_rad);
  }
}

}  // namespace openr_host
