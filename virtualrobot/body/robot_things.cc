#include "virtualrobot/body/robot_things.h"

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

const Vector3d kSilver(0.80, 0.81, 0.83), kGrey(0.44, 0.45, 0.48), kBlack(0.13, 0.13, 0.15);

Vector3d ColourOfPart(const BodyPart& part) {
  if (part.name == "mouth") return kBlack;
  const bool is_grey =
      part.name.ends_with("_j3") || part.name.starts_with("neck") || part.name.starts_with("tail");
  return is_grey ? kGrey : kSilver;
}

WorldThing ThingAt(const Eigen::Isometry3d& X_WL, const Vector3d& centre_m, const Vector3d& size_m,
                   const Vector3d& colour) {
  WorldThing thing;
  thing.size_m = size_m;
  thing.centre_m = X_WL * centre_m;
  thing.R_WT = X_WL.linear();
  thing.colour = colour;
  return thing;
}

}  // namespace

std::vector<WorldThing> ThingsOfRobot(const RobotModel& model,
                                      const std::vector<Eigen::Isometry3d>& X_WL,
                                      const std::vector<bool>& is_left_out) {
  ASSERT(X_WL.size() == model.bodies.size() && is_left_out.size() == X_WL.size(), "{} poses",
         X_WL.size());
  constexpr double kThin_m = 0.002;
  std::vector<WorldThing> things;
  for (size_t i = 0; i < model.bodies.size(); ++i) {
    const BodyPart& part = model.bodies[i];
    if (is_left_out[i] || !part.has_box || part.size_m.minCoeff() <= kThin_m) continue;
    things.push_back(ThingAt(X_WL[i], part.centre_m, part.size_m, ColourOfPart(part)));
    things.back().name = part.name;
  }
  for (const Paw& paw : model.paws) {
    const auto part = static_cast<size_t>(paw.body);
    if (paw.body < 0 || is_left_out[part]) continue;
    things.push_back(
        ThingAt(X_WL[part], paw.centre_m, Vector3d::Constant(2 * paw.radius_m), kBlack));
    things.back().name = paw.leg;
    things.back().shape = ThingShape::kSphere;
  }
  return things;
}

}  // namespace openr_host
