// The actions of `openr rc` that print the packets which the robot sends as streams.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "openr/commands/rc_actions.h"
#include "openr/commands/rc_format.h"
#include "openr/remote/connection.h"
#include "openr/remote/sensor_format.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr int64_t kVectorUs = 32'000;  // duration of a sensor vector, which has 4 frames of 8 ms
// Largest period of a stream in frames: the largest multiple of 4 (frames in a sensor vector) that
// fits into 16 bits.
constexpr int kPeriodMax = 65532;

// Returns the number of frames in the time `every_us`, rounded up to whole sensor vectors.
int PeriodOf(int64_t every_us) {
  const int64_t vectors = (every_us + kVectorUs - 1) / kVectorUs;
  return static_cast<int>(
      std::min<int64_t>(std::max<int64_t>(vectors, 1) * RC_FRAMES_PER_VECTOR, kPeriodMax));
}

// Formats the packets of the stream SetValues, in which the robot reports the commanded and the
// measured position of each joint.  The packets have the positions in the order of the joints, and
// this class adds the names.
class SetValueFormat {
 public:
  explicit SetValueFormat(remote::Connection* robot) : joints_(robot->Devices(rcdeviceJOINT)) {}

  Json ToJson(const remote::SetValues& values) const {
    Json json = {{"state", remote::StateName(values.state)},
                 {"key_frame", values.keyFrame},
                 {"file", values.file},
                 {"is_over", values.isOver != 0},
                 {"commanded_deg", Json::object()},
                 {"measured_deg", Json::object()}};
    for (size_t i = 0; i < Count(values); ++i) {
      json["commanded_deg"][joints_[i].name] = values.commanded[i] / 100.0;
      json["measured_deg"][joints_[i].name] = values.measured[i] / 100.0;
    }
    return json;
  }

  std::string ToText(const remote::SetValues& values) const {
    std::string text = remote::StateName(values.state);
    if (values.keyFrame < 0) return text + (values.isOver != 0 ? values.file + " is over" : "");
    text += fmt::format(" {} key frame {}: commanded, measured", values.file, values.keyFrame);
    for (size_t i = 0; i < Count(values); ++i) {
      text += fmt::format("\n  {:<12} {:8.2f} {:8.2f} deg", joints_[i].name,
                          values.commanded[i] / 100.0, values.measured[i] / 100.0);
    }
    return text;
  }

 private:
  size_t Count(const remote::SetValues& values) const {
    return std::min(joints_.size(), values.commanded.size());
  }

  const std::vector<remote::Description> joints_;
};

// Prints `event`.  Also prints how many times the robot left out the values of the stream between
// the previous event and `event`.
void PrintEvent(const RcFlags& flags, const remote::Event& event, Json json, std::string text) {
  if (event.left_out > 0) text += fmt::format("\n  {} left out before", event.left_out);
  json["left_out"] = event.left_out;
  PrintRcAnswer(flags.json, event.frame, json, text);
}

}  // namespace

void RcStreamAction(remote::Connection* robot, const RcFlags& flags) {
  const remote::SensorFormat sensors(robot);
  const SetValueFormat set_values(robot);
  const bool is_sensors = flags.stream == "sensors";
  robot->Subscribe(is_sensors ? rcstreamSENSORS : rcstreamSET_VALUES, PeriodOf(flags.stream_us));
  for (int i = 0; flags.count == 0 || i < flags.count; ++i) {
    const remote::Event event = robot->NextEvent();
    if (is_sensors) {
      const auto values = robot->Read<remote::Sensors>(event);
      PrintEvent(flags, event, sensors.ToJson(values), sensors.ToText(values));
    } else {
      const auto values = robot->Read<remote::SetValues>(event);
      PrintEvent(flags, event, set_values.ToJson(values), set_values.ToText(values));
    }
  }
}

}  // namespace openr_host
