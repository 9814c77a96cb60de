// The action of `openr rc camera`.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/output_file.h"
#include "openr/commands/rc_actions.h"
#include "openr/commands/rc_format.h"
#include "openr/remote/remote_camera.h"

namespace openr_host {

void RcCameraAction(RemoteClient* client, const RcFlags& flags) {
  const auto layer = static_cast<int>(std::string("hmlc").find(flags.layer));
  const RemotePicture picture =
      FetchPicture(client, layer, static_cast<int>(flags.timeout_us / 1000));
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
