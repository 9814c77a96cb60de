// Error handling for calls of Cyclone DDS.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include "distribution/dds.h"

namespace openr_host {

// Returns `result` if the call succeeded; throws a std::runtime_error that names `what` and the
// error otherwise.
inline dds_entity_t Check(dds_entity_t result, std::string_view what) {
  if (result >= 0) return result;
  throw std::runtime_error(fmt::format("Cyclone DDS: {}: {}", what, Dds().dds_strretcode(-result)));
}

}  // namespace openr_host
