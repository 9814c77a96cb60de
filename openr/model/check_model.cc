#include "openr/model/check_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/rotation.h"
#include "virtualrobot/body/body_mover.h"
#include "virtualrobot/body/kinematics.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

Vector3d RpyDegrees(const Eigen::Isometry3d& X_WB) { return RpyOf(X_WB.linear()) * Degrees(1.0); }

// Adds a problem to `check` if `value` is larger than `max`.  `what` names the value in the text of
// the problem.
void Limit(const char* what, double value, double max, const char* unit, ModelCheck* check) {
  if (value <= max) return;
  check->problems.push_back(
      fmt::format("{} is {:.2f} {}; at most {} {} is good", what, value, unit, max, unit));
}

void Judge(const RobotModel& model, ModelCheck* check) {
  Limit("the difference of the pitch from kinematics",
        std::fabs(check->pitch_deg - check->stiff_pitch_deg), kPitchToleranceDeg, "degrees", check);
  Limit("the difference of the height from kinematics",
        std::fabs(check->height_mm - check->stiff_height_mm), kHeightToleranceMm, "mm", check);
  Limit("the roll", std::fabs(check->roll_deg), kPitchToleranceDeg, "degrees", check);
  Limit("the largest error of a joint", check->static_error_deg_max, kStaticErrorMaxDeg, "degrees",
        check);
  Limit("the drift in 60 s", check->drift_60s_mm, kDriftMaxMm, "mm", check);
  Limit("the turn in 60 s", check->drift_60s_deg, kDriftMaxDeg, "degrees", check);
  if (check->paws < static_cast<int>(model.paws.size())) {
    check->problems.push_back(
        fmt::format("{} of {} paws are on the floor", check->paws, model.paws.size()));
  }
}

}  // namespace

ModelCheck CheckModel(const RobotModel& model) {
  const std::unique_ptr<Body> body = MakeOdeBody(model, World());
  BodyMover mover(model, body.get());
  mover.StandUp();
  ModelCheck check;
  check.total_mass_g = model.TotalMassKg() * 1000;
  check.static_error_deg_max = mover.JointErrorDegrees();
  const Eigen::Isometry3d start = body->state().X_WB;
  const Vector3d rpy_deg = RpyDegrees(start);
  const Vector3d place_m = body->state().X_WB.translation();
  check.roll_deg = rpy_deg.x();
  check.pitch_deg = rpy_deg.y();
  check.height_mm = place_m.z() * 1000;
  const std::vector<bool>& paws = body->state().paws;
  check.paws = static_cast<int>(std::count(paws.begin(), paws.end(), true));

  const RestingPose stiff = PlaceOnFloor(model, mover.Posture("stand"));
  check.stiff_pitch_deg = RpyDegrees(stiff.X_WB).y();
  check.stiff_height_mm = stiff.X_WB.translation().z() * 1000;

  mover.Hold(60);
  check.drift_60s_mm = (body->state().X_WB.translation() - place_m).norm() * 1000;
  const Eigen::Isometry3d turn = start.inverse() * body->state().X_WB;
  check.drift_60s_deg = RpyDegrees(turn).cwiseAbs().maxCoeff();
  Judge(model, &check);
  return check;
}

}  // namespace openr_host
