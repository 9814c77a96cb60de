// Makes, places and reads bodies of ODE, for the parts of robots and for movable things.
#pragma once

#include <ode/ode.h>

#include <Eigen/Core>

#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {

// Initialises ODE once per process.  It runs without threads, because the results of its thread
// pool are not repeatable.
void InitOde();

// Makes the ODE body of `part`.  The body has the mass of the part, with uniform density inside the
// box of the part (Hohl 2004, section 3.1.3).  The body belongs to `world`.
dBodyID MakeBody(dWorldID world, const BodyPart& part);

// Makes the ODE body of a thing that can move, with uniform density.  The body belongs to `world`.
dBodyID MakeBodyOfThing(dWorldID world, const WorldThing& thing);

// Moves `body` so that its centre of mass is at `centre_W`, and gives it the rotation `R_WL` from
// its own axes L to W.
void PlaceBody(dBodyID body, const Eigen::Vector3d& centre_W, const Eigen::Matrix3d& R_WL);

double MassOf(dBodyID body);

// Returns the inertia of `body` about its centre of mass, in its own axes, in kg m^2.
Eigen::Matrix3d InertiaOf(dBodyID body);

// Returns the rotation R_WL of `body`, from its own axes L to W.
Eigen::Matrix3d RotationOf(dBodyID body);

inline Eigen::Vector3d ToEigen(const dReal* v) { return {v[0], v[1], v[2]}; }

}  // namespace openr_host
