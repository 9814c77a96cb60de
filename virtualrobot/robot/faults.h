// Faults of a robot: joints that are jammed, weak or without power, sensors that are stuck, noisy
// or dead, parts that cannot be opened, heat, and a current that something else draws from the
// battery.
//
// Faults are inputs (runtime/core/inputs.h), such as "break LF_j1 weak 30% for 2s".  A fault lasts
// for its duration, or until it is repaired.  docs/inputs.md describes the inputs.
#pragma once

#include <OPENR/OPENR.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/core/inputs.h"

namespace openr_host {

class Hasher;
struct RobotParts;
struct RobotModel;

class Faults {
 public:
  // `robot` must outlive the faults.
  explicit Faults(RobotParts* robot) : robot_(*robot) {}

  // Adds the inputs for faults, such as "break" and "repair", to the System of this robot, so that
  // people and scripts can use them.
  void AddInputs();

  // Returns the faults that the input "break" knows, such as "jammed".
  static std::vector<std::string> Names();

  // Ends the faults that are over, and chooses at random the errors that noisy sensors of joints
  // add to their angles in the next frame.  Called before the body moves and its sensors are
  // sampled.
  void DoFrame();

  // Adds an error finding for each limb of which all joints are missing, because a robot does not
  // boot without a limb.  Called while the robot boots, after the inputs that act before the boot
  // (is_before_boot), because these inputs can make parts missing.
  void ReportMissingLimbs() const;

  // Returns the faults that the robot has now, a text for each fault, such as "LF_j1 weak 30%".
  std::vector<std::string> Present() const;

  void HashState(Hasher* hasher) const;

 private:
  // A joint can have one of the first three kinds of faults and, at its sensor, one of the next
  // three.  The next two are not faults of joints: kHot heats the body or the battery, kDraw takes
  // a current from the battery.  Every primitive can be missing.
  enum class Kind { kJammed, kWeak, kUnpowered, kStuck, kNoisy, kDead, kHot, kDraw, kMissing };
  enum class Part { kMotor, kSensor, kBody, kBattery, kSupply, kPrimitive };
  // The part that has a fault.  `number` is the index of the joint or the sensor, or the id of the
  // primitive; 0 for other parts.
  struct Place {
    Part part;
    int number = 0;
    auto operator<=>(const Place&) const = default;
  };
  struct Fault {
    Kind kind;
    int amount = 0;  // how strong the fault is; in percent, degrees Celsius or mA
    // Number of frames for which the fault goes on.  nullopt: it goes on until a repair.
    std::optional<int64_t> frames;
  };

  // The next functions read the words after the kind of an input ("break", "heat", ...), as
  // Inputs::Kind::read does.  Each returns "" or the error.
  std::string ReadBreak(std::string_view rest, Inputs::Action* action);
  // Reads the input "break PART missing".  `words` are the words after "break", without a duration,
  // and `fault` has the duration.
  std::string ReadMissing(const std::vector<std::string>& words, const Fault& fault,
                          Inputs::Action* action);
  std::string ReadHeat(std::string_view rest, Inputs::Action* action);
  std::string ReadDraw(std::string_view rest, Inputs::Action* action);
  std::string ReadRepair(std::string_view rest, Inputs::Action* action);

  // Finds the sensors and joints with the name `name`.  Writes the indices of the sensors to
  // `sensors`; for a joint, this is the index of its sensor.  Returns "" or the error.
  std::string FindSensors(const std::string& name, std::vector<int>* sensors) const;
  // Finds the primitives with the name or locator `name`, and writes their ids to `ids`.  Lights
  // and other primitives without a sensor have only locators.  Returns "" or the error.
  std::string FindPrimitives(const std::string& name, std::vector<OPrimitiveID>* ids) const;
  // Returns the place of a fault of kind `kind` at the part with the sensor `sensor`: the joint of
  // the sensor for kJammed, kWeak and kUnpowered, and the sensor for the other kinds.  Returns
  // nullopt when the fault needs a joint and the sensor does not belong to a joint.
  std::optional<Place> PlaceOf(Kind kind, int sensor) const;
  void Begin(const Place& place, const Fault& fault);
  void End(const Place& place);
  std::string NameOf(const Place& place) const;

  RobotParts& robot_;
  std::map<Place, Fault> faults_;
};

}  // namespace openr_host
