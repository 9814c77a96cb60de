#include "openr/simulation/standing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "virtualrobot/body/kinematics.h"

namespace openr_host {
namespace {

constexpr char kPosture[] = "stand";

}  // namespace

StandingMonitor::StandingMonitor(const RobotModel& model) : model_(&model) {
  for (const Posture& posture : model.postures) {
    if (posture.name == kPosture && model.paws.size() == 4) posture_ = StanceAt(posture.angles_rad);
  }
}

StandingMonitor::Stance StandingMonitor::StanceAt(const std::vector<double>& angles_rad) const {
  const std::vector<Eigen::Isometry3d> X_BL = LinkPoses(*model_, angles_rad);
  // Places of the paws in the coordinate frame B of the robot's base (virtualrobot/body/body.h), in
  // m: left fore, left hind, right fore, right hind.
  std::array<Eigen::Vector3d, 4> paws_B;
  for (size_t i = 0; i < paws_B.size(); ++i) {
    const Paw& paw = model_->paws[i];
    paws_B[i] = X_BL[static_cast<size_t>(paw.body)] * paw.centre_m;
  }
  Stance stance;
  // Four paws need not lie in one plane.  Uses the plane that is parallel to both diagonals between
  // the paws, and half way between them, because all four paws have the same distance from it.
  stance.up_B = (paws_B[3] - paws_B[0]).cross(paws_B[2] - paws_B[1]).normalized();
  const Eigen::Vector3d middle_B = (paws_B[0] + paws_B[1] + paws_B[2] + paws_B[3]) / 4;
  stance.height_m = model_->paws[0].radius_m - middle_B.dot(stance.up_B);
  const Eigen::Vector3d& up_B = stance.up_B;
  stance.roll_rad = DetAtan2(up_B.y(), up_B.z());
  stance.pitch_rad = DetAtan2(-up_B.x(), std::sqrt(up_B.y() * up_B.y() + up_B.z() * up_B.z()));
  return stance;
}

bool StandingMonitor::standing() const {
  if (!posture_ || !all_paws_touch_ || resting_us_ < kRestingUs) return false;
  const Stance now = StanceAt(angles_rad_);
  return (R_WB_ * now.up_B).z() >= DetCos(kSlopeMaxRad) &&
         std::abs(now.height_m - posture_->height_m) <= kHeightToleranceM &&
         std::abs(now.roll_rad - posture_->roll_rad) <= kAttitudeToleranceRad &&
         std::abs(now.pitch_rad - posture_->pitch_rad) <= kAttitudeToleranceRad;
}

void StandingMonitor::Sample(const BodyState& state, int64_t now_us) {
  const int64_t passed_us = last_us_ < 0 ? 0 : now_us - last_us_;
  last_us_ = now_us;
  resting_us_ = state.v_WB.norm() < kSpeedMaxMs ? resting_us_ + passed_us : 0;
  // Stores attitude, joint angles and the touch of the paws only while the robot rests, because
  // standing() needs them only then.
  if (resting_us_ < kRestingUs) return;
  all_paws_touch_ =
      std::all_of(state.paws.begin(), state.paws.end(), [](bool touches) { return touches; });
  R_WB_ = state.X_WB.linear();
  angles_rad_.resize(state.joints.size());
  for (size_t i = 0; i < state.joints.size(); ++i) angles_rad_[i] = state.joints[i].angle_rad;
}

}  // namespace openr_host
