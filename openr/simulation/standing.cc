#include "openr/simulation/standing.h"

#include <algorithm>
#include <cmath>

#include "virtualrobot/kinematics.h"

namespace openr_host {
namespace {

constexpr char kPosture[] = "stand";

}  // namespace

StandingMonitor::StandingMonitor(const RobotModel& model) {
  for (const Posture& posture : model.postures) {
    if (posture.name != kPosture) continue;
    const RestingPose rest = PlaceOnFloor(model, posture.angles_rad);
    const Eigen::Vector3d rpy_rad = RpyOf(rest.X_WB.linear());
    height_m_ = rest.X_WB.translation().z();
    roll_rad_ = rpy_rad.x();
    pitch_rad_ = rpy_rad.y();
    has_posture_ = true;
  }
}

bool StandingMonitor::IsUpright(const BodyState& state) const {
  if (!has_posture_) return false;
  const Eigen::Vector3d rpy_rad = RpyOf(state.X_WB.linear());
  return std::all_of(state.paws.begin(), state.paws.end(), [](bool touches) { return touches; }) &&
         std::abs(state.X_WB.translation().z() - height_m_) <= kHeightToleranceM &&
         std::abs(rpy_rad.x() - roll_rad_) <= kAttitudeToleranceRad &&
         std::abs(rpy_rad.y() - pitch_rad_) <= kAttitudeToleranceRad;
}

void StandingMonitor::Sample(const BodyState& state, int64_t now_us) {
  const int64_t passed_us = last_us_ < 0 ? 0 : now_us - last_us_;
  last_us_ = now_us;
  upright_ = IsUpright(state);
  calm_us_ = state.v_WB.norm() < kSpeedMaxMs ? calm_us_ + passed_us : 0;
}

}  // namespace openr_host
