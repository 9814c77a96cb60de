#include "openr/commands/rc_format.h"

#include <fmt/format.h>

#include "cli/standard_streams.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr uint32_t kNoFrame = 0xffffffff;

}  // namespace

std::string FrameText(uint32_t frame) {
  return frame == kNoFrame ? "frame -:" : fmt::format("frame {}:", frame);
}

Json FrameJson(uint32_t frame) { return frame == kNoFrame ? Json() : Json(frame); }

void PrintRcAnswer(bool as_json, uint32_t frame, const Json& json, const std::string& text) {
  if (as_json) {
    Json answer = {{"frame", FrameJson(frame)}};
    answer.update(json);
    PrintAnswer(answer.dump() + "\n");
  } else {
    PrintAnswer(fmt::format("{} {}\n", FrameText(frame), text));
  }
  FlushAnswer();
}

}  // namespace openr_host
