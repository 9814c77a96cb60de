#include "openr/data/mcap_log.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "cli/base64.h"
#include "cli/json_text.h"
#include "openr/data/mcap_schemas.h"
#include "openr/data/scene_messages.h"
#include "openr/decode/decode_message.h"
#include "openr/render/png_file.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Longest virtual time between the ends of two chunks of messages in an MCAP file.
constexpr int64_t kChunkUs = 1'000'000;
// Number of bytes at which a chunk of messages in an MCAP file ends, even if kChunkUs have not
// passed yet.
constexpr size_t kChunkBytes = 1 << 20;
constexpr int64_t kPoseDistanceUs = 32'000;  // least virtual time between two messages with poses
// Largest number of characters of a finding's or an input's text that are written to an MCAP file;
// the rest is left out.
constexpr size_t kTextMax = 2000;

// The place of a quantity in an MCAP file: a robot, a topic, and a member of the topic's messages.
struct QuantityPlace {
  size_t robot = 0;
  std::string topic, key;
};

// Splits the name of a quantity into its parts: "robots[1].joint.LF_j1" is the member "LF_j1" of
// the topic "joint" of robot 1. A name without such a topic, as "x_m", is a member of the topic
// "base".
QuantityPlace PlaceOfQuantity(const std::string& name) {
  QuantityPlace place;
  std::string rest = name;
  if (name.starts_with("robots[")) {
    place.robot = std::stoul(name.substr(7));
    rest = name.substr(name.find("].") + 2);
  }
  const size_t dot = rest.find('.');
  place.topic = dot == std::string::npos ? "base" : rest.substr(0, dot);
  place.key = dot == std::string::npos ? rest : rest.substr(dot + 1);
  return place;
}

}  // namespace

McapLog::McapLog(const DataLogOptions& options, Simulation* simulation)
    : options_(options),
      simulation_(simulation),
      view_(simulation),
      columns_(ColumnsOf(view_.run())),
      file_(options.file),
      writer_("openr-host " OPENR_VERSION,
              [this](std::string_view bytes) { file_.Append(bytes); }) {
  AddValueTopics();
  AddScene();
  const uint16_t log = writer_.AddSchema("foxglove.Log", kLogSchema);
  findings_ = writer_.AddChannel("/findings", log);
  inputs_ = writer_.AddChannel("/inputs", log);
  System& system = simulation->system();
  system.inputs().OnAdd([this, &system](int robot, std::string_view line) {
    AddText(inputs_, system.now_us(), kLogInfo, fmt::format("robot {}", robot), std::string(line));
  });
}

// Returns the first part of the names of a robot's topics, such as "/aibo".  The robot's topics in
// ROS 2 begin with the same name.
std::string McapLog::Space(size_t robot) const {
  return simulation_->robots().size() == 1 ? "/aibo" : fmt::format("/aibo{}", robot);
}

void McapLog::AddValueTopics() {
  std::map<std::pair<size_t, std::string>, Values> topics;
  for (size_t i = 0; i < columns_.size(); ++i) {
    const QuantityPlace place = PlaceOfQuantity(columns_[i].name);
    Values& values = topics[{place.robot, place.topic}];
    values.keys.push_back(JsonText(nlohmann::json(place.key)));
    values.columns.push_back(i);
  }
  for (auto& [key, values] : topics) {
    const auto& [robot, topic] = key;
    values.channel =
        writer_.AddChannel(Space(robot) + "/" + topic,
                           writer_.AddSchema("openr." + topic, ValueSchema(topic, values.keys)));
    values_.push_back(std::move(values));
  }
}

// Adds the topics of poses, shapes and camera pictures to the MCAP file, and the message with the
// shapes.
void McapLog::AddScene() {
  poses_ = writer_.AddChannel("/tf", writer_.AddSchema("foxglove.FrameTransforms", kPosesSchema));
  const uint16_t scene = writer_.AddSchema("foxglove.SceneUpdate", kSceneSchema);
  const uint16_t image = writer_.AddSchema("foxglove.CompressedImage", kImageSchema);
  writer_.Add(writer_.AddChannel("/world", scene), 0, WorldScene(simulation_->world()));
  for (size_t i = 0; i < simulation_->robots().size(); ++i) {
    writer_.Add(writer_.AddChannel(Space(i) + "/shapes", scene), 0,
                RobotSceneMessage(simulation_->model(), Space(i).substr(1)));
    cameras_.push_back({writer_.AddChannel(Space(i) + "/camera", image)});
  }
}

void McapLog::Sample() {
  const int64_t now_us = simulation_->system().now_us();
  if (now_us == last_us_ || is_finished_) return;
  last_us_ = now_us;
  view_.Sample();
  AddValues(now_us);
  if (now_us % kPoseDistanceUs == 0) AddPoses(now_us);
  if (options_.image_distance_us > 0) AddImages(now_us);
  AddFindings();
  if (now_us - chunk_us_ < kChunkUs && writer_.chunk_bytes() < kChunkBytes) return;
  chunk_us_ = now_us;
  writer_.EndChunk();
}

void McapLog::AddValues(int64_t now_us) {
  std::string text;
  for (const Values& values : values_) {
    text = "{" + TimestampText(now_us);
    for (size_t i = 0; i < values.keys.size(); ++i) {
      const double value = std::get<double>(columns_[values.columns[i]].read(view_.run()));
      if (std::isnan(value)) continue;  // leaves the quantity out, because JSON has no NaN
      text += "," + values.keys[i] + ":";
      AppendNumber(value, &text);
    }
    writer_.Add(values.channel, now_us, text + "}");
  }
}

void McapLog::AddPoses(int64_t now_us) {
  std::string text;
  size_t number = 0;
  for (const VirtualRobot* const robot : simulation_->robots()) {
    const std::string space = Space(number++).substr(1);
    const std::vector<Eigen::Isometry3d> poses = robot->body().BodyPoses();
    for (size_t i = 0; i < poses.size(); ++i)
      AppendTransform(now_us, space + "/" + robot->model().bodies[i].name, poses[i], &text);
    // Adds the things of a world only once, because several robots in one world see the same
    // things.
    if (simulation_->is_together() && number > 1) continue;
    for (const WorldThing& thing : robot->body().MovableThings()) {
      Eigen::Isometry3d X_WT(thing.R_WT);
      X_WT.pretranslate(thing.centre_m);
      AppendTransform(now_us, "thing/" + thing.name, X_WT, &text);
    }
  }
  writer_.Add(poses_, now_us, "{\"transforms\":[" + text + "]}");
}

void McapLog::AddImages(int64_t now_us) {
  for (size_t i = 0; i < cameras_.size(); ++i) {
    CameraTopic& camera = cameras_[i];
    VirtualRobot* const robot = simulation_->robots()[i];
    const bool is_early =
        camera.last_us >= 0 && now_us - camera.last_us < options_.image_distance_us;
    const bool is_off = simulation_->system().robot(static_cast<int>(i)).powered_off;
    if (camera.is_broken || is_early || is_off || !robot->HasNewImage()) continue;
    if (const std::string problem = robot->CopyPicture(&picture_); !problem.empty()) {
      camera.is_broken = true;
      AddText(findings_, now_us, kLogError, "camera", problem);
      continue;
    }
    camera.last_us = now_us;
    writer_.Add(
        camera.channel, now_us,
        fmt::format("{{{},\"frame_id\":\"{}/camera_optical\",\"format\":\"png\",\"data\":\"{}"
                    "\"}}",
                    TimestampText(now_us), Space(i).substr(1),
                    ToBase64(render::EncodePng(picture_.width, picture_.height, picture_.rgb))));
  }
}

void McapLog::AddFindings() {
  const std::vector<Finding>& all = simulation_->system().findings().all();
  for (; finding_count_ < all.size(); ++finding_count_) {
    const Finding& finding = all[finding_count_];
    const int level = finding.severity == Severity::kError     ? kLogError
                      : finding.severity == Severity::kWarning ? kLogWarning
                                                               : kLogInfo;
    AddText(findings_, finding.time_us, level, finding.object,
            finding.text + MessageInParentheses(finding.message, finding.said));
  }
}

void McapLog::AddText(uint16_t channel, int64_t time_us, int level, const std::string& name,
                      const std::string& text) {
  if (is_finished_) return;
  const auto quoted = [](const std::string& words) {
    return JsonText(nlohmann::json(words.substr(0, kTextMax)));
  };
  writer_.Add(channel, time_us,
              fmt::format("{{{},\"level\":{},\"message\":{},\"name\":{},\"file\":\"\",\"line\":0}}",
                          TimestampText(time_us), level, quoted(text), quoted(name)));
}

std::string McapLog::Finish() {
  if (!is_finished_) {
    AddFindings();
    is_finished_ = true;
    writer_.Finish();
  }
  return file_.Problem();
}

}  // namespace openr_host
