// The requests that objects send to primitives (joints, lights, the speaker ...) by calls of
// OPENR::ControlPrimitive().
#pragma once

#include <OPENR/OPENRAPI.h>

#include <cstddef>

namespace openr_host {

class VirtualRobot;

// Carries out `request` to primitive `id` of `robot`, as OPENR::ControlPrimitive() does.  Returns
// oINVALID_PRIMITIVE_ID if the robot has no such primitive, and oINVALID_ARG with a warning if the
// primitive does not accept the request or if a size is wrong.
OStatus CarryOutRequest(VirtualRobot* robot, OPrimitiveID id, OPrimitiveRequest request,
                        const void* param, size_t param_size, void* result, size_t result_size);

}  // namespace openr_host
