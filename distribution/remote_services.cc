#include "distribution/remote_services.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "distribution/ask_master.h"
#include "runtime/core/region_table.h"

namespace openr_host {

template <auto kFunction, typename... Arguments>
OStatus RemoteServices::Ask(const Arguments&... arguments) {
  return AskMaster<kFunction>(master_, arguments...);
}

#define OPENR_ASK(name, parameters, arguments, without_devices) \
  OStatus RemoteServices::name parameters { return Ask<&RobotServices::name> arguments; }
// Expands to nothing.  OPENR_ROBOT_CALLS uses this macro for functions of RobotServices that pass
// bytes of memory.  These functions of RemoteServices are written by hand below.
#define OPENR_ASK_WITH_MEMORY(name, parameters, arguments, without_devices)
OPENR_ROBOT_CALLS(OPENR_ASK, OPENR_ASK_WITH_MEMORY)
#undef OPENR_ASK
#undef OPENR_ASK_WITH_MEMORY

OStatus RemoteServices::ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param,
                                         size_t param_size, void* result, size_t result_size) {
  const std::string parameter(static_cast<const char*>(param), param == nullptr ? 0 : param_size);
  const uint64_t wanted = result == nullptr ? 0 : result_size;
  std::string bytes;
  std::string* const to = &bytes;
  const OStatus status =
      AskMaster<&CheckedCalls::ControlPrimitive>(master_, id, request, parameter, wanted, to);
  if (result != nullptr) std::memcpy(result, bytes.data(), std::min(result_size, bytes.size()));
  return status;
}

OStatus RemoteServices::SetCdtVectorData(MemoryRegionID id) {
  const char* const base = regions_->BaseOf(id);
  const std::string bytes(base == nullptr ? "" : base, regions_->SizeOf(id));
  return AskMaster<&CheckedCalls::SetCdtVectorData>(master_, id, bytes);
}

}  // namespace openr_host
