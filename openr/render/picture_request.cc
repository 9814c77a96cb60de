#include "openr/render/picture_request.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdio>

#include "cli/install_paths.h"
#include "cli/output_file.h"
#include "openr/render/png_file.h"
#include "runtime/base/duration.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {
namespace {

constexpr int kSizeMinPx = 16;
constexpr int kSizeMaxPx = 4096;

std::string ParsePart(std::string_view key, const std::string& value, PictureRequest* plan) {
  if (key == "t") {
    if (value != "end") return ParseDuration(value, &plan->time_us);
    plan->time_us = -1;
    return "";
  }
  if (key == "view") {
    if (ParseView(value, &plan->view)) return "";
    return fmt::format(
        "unknown view '{}'; there are side, front, top, iso, follow, world, "
        "camera",
        value);
  }
  int length = 0;
  if (key == "size") {
    const int got =
        std::sscanf(value.c_str(), "%dx%d%n", &plan->width_px, &plan->height_px, &length);
    const auto fits = [](int size) { return size >= kSizeMinPx && size <= kSizeMaxPx; };
    if (got == 2 && value.size() == static_cast<size_t>(length) && fits(plan->width_px) &&
        fits(plan->height_px)) {
      return "";
    }
    return fmt::format("size '{}' is not like 1280x720, with {} to {} pixels each", value,
                       kSizeMinPx, kSizeMaxPx);
  }
  if (key == "robot") {
    if (std::sscanf(value.c_str(), "%d%n", &plan->robot, &length) == 1 && plan->robot >= 0 &&
        value.size() == static_cast<size_t>(length)) {
      return "";
    }
    return fmt::format("robot '{}' is no number; the first robot is 0", value);
  }
  return fmt::format("unknown part '{}'; there are t, view, size, robot", key);
}

}  // namespace

std::string ParsePictureRequest(std::string_view text, PictureRequest* plan) {
  bool has_size = false;
  while (!text.empty()) {
    const size_t comma = text.find(',');
    const std::string_view part = text.substr(0, comma);
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
    const size_t equals = part.find('=');
    if (equals == std::string_view::npos) {
      return fmt::format("'{}' is not like t=5s or view=side", part);
    }
    const std::string problem =
        ParsePart(part.substr(0, equals), std::string(part.substr(equals + 1)), plan);
    if (!problem.empty()) return problem;
    has_size = has_size || part.starts_with("size=");
  }
  if (has_size && plan->view == View::kCamera)
    return "view=camera has the size of the robot's camera; leave out size";
  return "";
}

std::string WritePicture(const PictureRequest& plan, VirtualRobot* robot,
                         const std::vector<VirtualRobot*>& company) {
  if (plan.view == View::kCamera) {
    Picture seen;
    const std::string problem = robot->CopyPicture(&seen);
    if (!problem.empty()) return fmt::format("{}: {}", plan.file, problem);
    return WriteFile(plan.file, render::EncodePng(seen.width, seen.height, seen.rgb));
  }
  const std::string library = RenderLibrary();
  static void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    return fmt::format("{}: no pictures: {} (Debian package libosmesa6)", plan.file, dlerror());
  }
  auto* const render =
      reinterpret_cast<render::RenderPicture*>(dlsym(handle, render::kRenderPictureName));
  if (render == nullptr) return fmt::format("{}: is of another version; build it again", library);

  render::Picture picture;
  picture.width_px = plan.width_px;
  picture.height_px = plan.height_px;
  World world = robot->body().world();
  const size_t things = world.things.size();
  world.things = robot->body().Surroundings();
  // Surroundings() returns the things of the world first, and then boxes for the parts of the other
  // robots.  Removes these boxes, because the other robots are drawn with their own shapes.
  world.things.resize(things);
  std::vector<RobotLook> looks = {LookOf(*robot)};
  for (const VirtualRobot* const other : company) {
    if (other != robot) looks.push_back(LookOf(*other));
  }
  std::string png, problem;
  render(MakeRobotScene(robot->model(), looks, world, plan.view), picture, &png, &problem);
  return problem.empty() ? WriteFile(plan.file, png) : fmt::format("{}: {}", plan.file, problem);
}

}  // namespace openr_host
