// Check(): turns an error of a call of Cyclone DDS into an exception.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include "distribution/dds.h"

namespace openr_host {

// Returns `result`, the result of a call of Cyclone DDS, if the call succeeded.  Otherwise throws a
// std::runtime_error that names the error and `what`, the thing that the call was to make or do.
inline dds_entity_t Check(dds_entity_t result, std::string_view what) {
  if (result >= 0) return result;
  throw std::runtime_error(fmt::format("Cyclone DDS: {}: {}", what, Dds().dds_strretcode(-result)));
}

}  // namespace openr_host
