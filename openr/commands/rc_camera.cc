// The action of `openr rc camera`, which fetches a picture from the robot's camera.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/output_file.h"
#include "openr/commands/rc_actions.h"
#include "openr/commands/rc_format.h"
#include "openr/remote/connection.h"

namespace openr_host {

void RcCameraAction(remote::Connection* robot, const RcFlags& flags) {
  const auto layer = static_cast<int>(std::string("hmlc").find(flags.layer));
  const remote::Picture picture = robot->TakePicture(layer);
  const std::string problem = WriteFile(flags.output, flags.raw ? picture.bytes : picture.File());
  if (!problem.empty()) throw std::runtime_error(problem);
  PrintRcAnswer(flags.json, picture.frame,
                {{"file", flags.output},
                 {"width", picture.width},
                 {"height", picture.height},
                 {"bands", picture.bands},
                 {"bytes", picture.bytes.size()}},
                fmt::format("{} x {} pixels, {} bands, {} bytes, are in {}", picture.width,
                            picture.height, picture.bands, picture.bytes.size(), flags.output));
}

}  // namespace openr_host
