#include "openr/data/scene_messages.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/json_text.h"
#include "openr/render/robot_shapes.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

Json XyzJson(const Eigen::Vector3d& v) { return {{"x", v.x()}, {"y", v.y()}, {"z", v.z()}}; }

Json PoseJson(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  return {{"position", XyzJson(pose.translation())},
          {"orientation", {{"x", q.x()}, {"y", q.y()}, {"z", q.z()}, {"w", q.w()}}}};
}

// Returns an entity of foxglove.SceneUpdate that has no shapes yet.  `frame` is the name of its
// coordinate frame.
Json EmptyEntity(const std::string& frame, const std::string& id) {
  Json entity = {{"timestamp", {{"sec", 0}, {"nsec", 0}}},
                 {"frame_id", frame},
                 {"id", id},
                 {"lifetime", {{"sec", 0}, {"nsec", 0}}},
                 {"frame_locked", true}};
  for (const char* const kind : {"metadata", "arrows", "cubes", "spheres", "cylinders", "lines",
                                 "triangles", "texts", "models"})
    entity[kind] = Json::array();
  return entity;
}

// Adds `shape` to the JSON of an entity (of foxglove.SceneUpdate).  `pose` is the pose of the shape
// in the coordinate frame of the entity.
void AddShape(const render::Shape& shape, const Eigen::Isometry3d& pose, Json* entity) {
  const auto part = [](float level) { return static_cast<double>(level); };
  Json json = {{"pose", PoseJson(pose)},
               {"size", XyzJson(shape.size_m)},
               {"color",
                {{"r", part(shape.colour.r)},
                 {"g", part(shape.colour.g)},
                 {"b", part(shape.colour.b)},
                 {"a", 1}}}};
  if (!shape.triangles.empty()) {
    json["points"] = Json::array();
    for (const Eigen::Vector3f& corner : shape.triangles)
      json["points"].push_back(XyzJson(corner.cast<double>()));
    json["colors"] = json["indices"] = Json::array();
    (*entity)["triangles"].push_back(json);
  } else if (shape.is_cylinder) {
    json["bottom_scale"] = json["top_scale"] = 1;
    (*entity)["cylinders"].push_back(json);
  } else {
    // Writes a box with rounded edges as a ball if the radius of the edges is at least half of the
    // longest side, because such a box is a ball.
    const bool is_ball = 2 * shape.radius_m >= shape.size_m.maxCoeff();
    (*entity)[is_ball ? "spheres" : "cubes"].push_back(json);
  }
}

std::string SceneOf(const std::vector<Json>& entities) {
  return JsonText(Json{{"deletions", Json::array()}, {"entities", entities}});
}

}  // namespace

std::string TimestampText(int64_t time_us) {
  return fmt::format("\"timestamp\":{{\"sec\":{},\"nsec\":{}}}", time_us / 1'000'000,
                     time_us % 1'000'000 * 1000);
}

void AppendTransform(int64_t time_us, const std::string& child, const Eigen::Isometry3d& pose,
                     std::string* text) {
  const Eigen::Vector3d p = pose.translation();
  const Eigen::Quaterniond q(pose.linear());
  fmt::format_to(
      std::back_inserter(*text),
      "{}{{{},\"parent_frame_id\":\"world\",\"child_frame_id\":{},\"translation\":{{"
      "\"x\":{:.6f},\"y\":{:.6f},\"z\":{:.6f}}},\"rotation\":{{\"x\":{:.6f},\"y\":{:.6f},"
      "\"z\":{:.6f},\"w\":{:.6f}}}}}",
      text->empty() ? "" : ",", TimestampText(time_us), JsonText(Json(child)), p.x(), p.y(), p.z(),
      q.x(), q.y(), q.z(), q.w());
}

std::string RobotSceneMessage(const RobotModel& model, const std::string& space) {
  std::vector<Json> entities;
  for (const BodyPart& part : model.bodies)
    entities.push_back(EmptyEntity(space + "/" + part.name, space + "/" + part.name));
  for (const RobotShape& shape : ShapesOfRobot(model))
    AddShape(shape.shape, PlaceInPart(shape, 0), &entities[static_cast<size_t>(shape.body)]);
  return SceneOf(entities);
}

std::string WorldScene(const World& world) {
  std::vector<Json> entities{EmptyEntity("world", "world")};
  const std::vector<render::Shape> shapes = ShapesOfWorld(world);
  for (size_t i = 0; i < shapes.size(); ++i) {
    const std::string frame = "thing/" + world.things[i].name;
    const bool can_move = world.things[i].mass_kg > 0;
    if (can_move) entities.push_back(EmptyEntity(frame, frame));
    AddShape(shapes[i], can_move ? Eigen::Isometry3d::Identity() : shapes[i].X_WS,
             can_move ? &entities.back() : &entities.front());
  }
  return SceneOf(entities);
}

}  // namespace openr_host
