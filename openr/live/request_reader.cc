#include "openr/live/request_reader.h"

#include <cstdint>
#include <nlohmann/json.hpp>

namespace openr_host {

int RobotOfRequest(const nlohmann::json& request, int robot_count) {
  const int64_t robot = RequestReader(request).WholeOr("robot", INT64_MIN, INT64_MAX, 0);
  if (robot < 0 || robot >= robot_count)
    throw std::runtime_error(
        fmt::format("there is no robot {}; this run has {}", robot, robot_count));
  return static_cast<int>(robot);
}

}  // namespace openr_host
