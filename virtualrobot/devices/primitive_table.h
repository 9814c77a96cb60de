// A table of the primitives of a robot, with the locator, id and kind of each.  A primitive is a
// device that OPEN-R can open: a joint, sensor, light, ear (plunger), speaker, microphone or
// camera.
//
// An id is 0x1000 plus the index of the primitive in this table, which begins with the elements of
// the sensor vector.  Because ids depend on the model only, they are the same for every object and
// in every run.  How the robot encodes its ids is not known.
#pragma once

#include <OPENR/OPENR.h>

#include <map>
#include <string>
#include <vector>

#include "virtualrobot/model/robot_model.h"

namespace openr_host {

class Hasher;

enum class PrimitiveKind { kJoint, kSensor, kLed, kPlunger, kSpeaker, kMicrophone, kCamera };

struct Primitive {
  std::string locator;
  PrimitiveKind kind = PrimitiveKind::kSensor;
  OPrimitiveType type = oprimitiveUNDEF;  // type that the locator names after its dash
  int index = -1;      // index in the RobotModel's list of primitives of this kind
  int sensor = -1;     // index of the primitive's element in sensor vectors; -1: no element
  int open_count = 0;  // calls of OpenPrimitive() minus calls of ClosePrimitive(); >= 0
  // Whether OpenPrimitive() fails for this primitive, as for a broken part of a real robot
  // (Faults).
  bool is_missing = false;

  bool opened() const { return open_count > 0; }
};

class PrimitiveTable {
 public:
  explicit PrimitiveTable(const RobotModel& model);

  // Returns the id of the primitive with exactly this locator; oprimitiveID_UNDEF when the robot
  // has no such primitive.
  OPrimitiveID IdOf(const std::string& locator) const;
  OPrimitiveID IdOfSensor(int sensor) const { return kFirstId + static_cast<OPrimitiveID>(sensor); }

  // Returns the primitive with this id; null when the robot has no such primitive.
  Primitive* Find(OPrimitiveID id);

  // Closes all primitives, as if OpenPrimitive() had never been called.
  void CloseAll();

  // Returns a line "ID LOCATOR" for each primitive, in order of the ids.
  std::string Lines() const;

  void HashState(Hasher* hasher) const;

 private:
  static constexpr OPrimitiveID kFirstId = 0x1000;

  void Add(const std::string& locator, PrimitiveKind kind, int index, int sensor);

  std::vector<Primitive> primitives_;
  std::map<std::string, OPrimitiveID> ids_;
};

}  // namespace openr_host
