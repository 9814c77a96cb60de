#include "openr/commands/rc_format.h"

#include <fmt/format.h>

#include <mutex>
#include <nlohmann/json.hpp>

#include "cli/json_text.h"
#include "cli/standard_streams.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr uint32_t kNoFrame = 0xffffffff;

// Address of the robot that has sent the answers which this thread prints.  RcRobotLabel sets the
// address, and each printed answer begins with it; "": answers begin without an address.
thread_local std::string t_robot;
std::mutex g_print_mutex;  // protects the output, because with two robots two threads print

}  // namespace

RcRobotLabel::RcRobotLabel(const std::string& address) { t_robot = address; }

RcRobotLabel::~RcRobotLabel() { t_robot.clear(); }

std::string FrameText(uint32_t frame) {
  return frame == kNoFrame ? "frame -:" : fmt::format("frame {}:", frame);
}

Json FrameJson(uint32_t frame) { return frame == kNoFrame ? Json() : Json(frame); }

void PrintRcAnswer(bool as_json, uint32_t frame, const Json& json, const std::string& text) {
  const std::lock_guard lock(g_print_mutex);
  if (as_json) {
    Json answer = {{"frame", FrameJson(frame)}};
    if (!t_robot.empty()) answer["robot"] = t_robot;
    answer.update(json);
    PrintAnswer(JsonText(answer) + "\n");
  } else {
    const std::string robot = t_robot.empty() ? "" : t_robot + " ";
    PrintAnswer(TerminalText(fmt::format("{}{} {}\n", robot, FrameText(frame), text)));
  }
  FlushAnswer();
}

}  // namespace openr_host
