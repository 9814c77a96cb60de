// Calls of Cyclone DDS that fail.
#pragma once

#include <dds/dds.h>
#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

namespace openr_host {

// `result` of a call, or a std::runtime_error with `what` was called and what Cyclone DDS says.
inline dds_entity_t Check(dds_entity_t result, std::string_view what) {
  if (result >= 0) return result;
  throw std::runtime_error(fmt::format("Cyclone DDS: {}: {}", what, dds_strretcode(-result)));
}

}  // namespace openr_host
