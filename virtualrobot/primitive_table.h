// All primitives of a robot: locator, id, kind.
//
// Ids depend on the model only, so they are the same for every object and in every run: 0x1000 plus
// the place in this table, which begins with the elements of the sensor vector.  How the robot
// encodes its ids is not known.
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
  OPrimitiveType type = oprimitiveUNDEF;  // named by the word behind the dash of the locator
  int index = -1;                         // index in the model's list of this kind
  int sensor = -1;                        // element of the sensor vector; -1: none
  int open_count = 0;                     // calls of OpenPrimitive() minus ClosePrimitive(), >= 0

  bool opened() const { return open_count > 0; }
};

class PrimitiveTable {
 public:
  explicit PrimitiveTable(const RobotModel& model);

  // oprimitiveID_UNDEF when the robot has no such locator (the whole string must match).
  OPrimitiveID IdOf(const std::string& locator) const;
  OPrimitiveID IdOfSensor(int sensor) const { return kFirstId + static_cast<OPrimitiveID>(sensor); }

  // Null when no primitive has that id.
  Primitive* Find(OPrimitiveID id);

  void HashState(Hasher* hasher) const;

 private:
  static constexpr OPrimitiveID kFirstId = 0x1000;

  void Add(const std::string& locator, PrimitiveKind kind, int index, int sensor);

  std::vector<Primitive> primitives_;
  std::map<std::string, OPrimitiveID> ids_;
};

}  // namespace openr_host
