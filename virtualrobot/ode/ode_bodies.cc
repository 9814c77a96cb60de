#include "virtualrobot/ode/ode_bodies.h"

namespace openr_host {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void InitOde() {
  static const int initialised = dInitODE2(0);
  static_cast<void>(initialised);
}

dBodyID MakeBody(dWorldID world, const BodyPart& part) {
  dMass mass;
  dMassSetBoxTotal(&mass, part.mass_kg, part.size_m.x(), part.size_m.y(), part.size_m.z());
  const dBodyID body = dBodyCreate(world);
  dBodySetMass(body, &mass);
  return body;
}

dBodyID MakeBodyOfThing(dWorldID world, const WorldThing& thing) {
  constexpr int kAlongZ = 3;
  const Vector3d& size = thing.size_m;
  dMass mass;
  switch (thing.shape) {
    // The mass of a heightfield does not matter, because no heightfield can move.
    case ThingShape::kHeightField:
    case ThingShape::kBox:
      dMassSetBoxTotal(&mass, thing.mass_kg, size.x(), size.y(), size.z());
      break;
    case ThingShape::kSphere:
      dMassSetSphereTotal(&mass, thing.mass_kg, size.x() / 2);
      break;
    case ThingShape::kCylinder:
      dMassSetCylinderTotal(&mass, thing.mass_kg, kAlongZ, size.x() / 2, size.z());
      break;
  }
  const dBodyID body = dBodyCreate(world);
  dBodySetMass(body, &mass);
  return body;
}

// Writes a 0 as the fourth number of each row of the rotation, because a row of an ODE matrix has
// four numbers, the last of which is not used.
void PlaceBody(dBodyID body, const Vector3d& centre_W, const Matrix3d& R_WL) {
  const Matrix3d& R = R_WL;
  const dMatrix3 rotation = {R(0, 0), R(0, 1), R(0, 2), 0,       R(1, 0), R(1, 1),
                             R(1, 2), 0,       R(2, 0), R(2, 1), R(2, 2), 0};
  dBodySetPosition(body, centre_W.x(), centre_W.y(), centre_W.z());
  dBodySetRotation(body, rotation);
}

Matrix3d RotationOf(dBodyID body) {
  const dReal* const r = dBodyGetRotation(body);
  Matrix3d R;
  R << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
  return R;
}

double MassOf(dBodyID body) {
  dMass mass;
  dBodyGetMass(body, &mass);
  return mass.mass;
}

Matrix3d InertiaOf(dBodyID body) {
  dMass mass;
  dBodyGetMass(body, &mass);
  Matrix3d inertia;
  inertia << mass.I[0], mass.I[1], mass.I[2], mass.I[4], mass.I[5], mass.I[6], mass.I[8], mass.I[9],
      mass.I[10];
  return inertia;
}

}  // namespace openr_host
