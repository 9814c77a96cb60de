#include "runtime/core/robot_services.h"

#include "runtime/base/hasher.h"

namespace openr_host {
namespace {

// Uses the parameters of a function and does nothing.  The compiler warns of parameters that are
// never used, and most functions of a robot without devices use none.
template <typename... Parameters>
void UseNothing(const Parameters&...) {}

}  // namespace

#define OPENR_DEFINE_CALL(name, parameters, arguments, without_devices) \
  OStatus RobotServices::name parameters {                              \
    UseNothing arguments;                                               \
    return without_devices;                                             \
  }
OPENR_ROBOT_CALLS(OPENR_DEFINE_CALL, OPENR_DEFINE_CALL)
#undef OPENR_DEFINE_CALL

void RobotServices::HashState(Hasher*) const {}

}  // namespace openr_host
