#include "virtualrobot/devices/safe_posture.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/hasher.h"

namespace openr_host {

void SafePosture::Apply(int64_t frame, Devices* devices) {
  for (LostCommander& lost : lost_commanders_) {
    const int64_t moved = frame - lost.since - kHoldFrames;
    if (moved < 0) continue;
    if (lost.from_urad.empty()) {
      for (const JointDevice& joint : devices->joints) lost.from_urad.push_back(joint.target_urad);
    }
    // Moves the set points to the sleeping posture in kMoveFrames equal steps, because they must
    // not jump.
    const std::vector<double> rest_rad = model_.PostureAngles("sleep");
    const int64_t step = std::min(moved, kMoveFrames);
    for (size_t j = 0; j < devices->joints.size(); ++j) {
      JointDevice& joint = devices->joints[j];
      if (joint.commander != lost.commander) continue;
      const auto rest_urad = static_cast<slongword>(std::floor(rest_rad[j] * 1e6 + 0.5));
      const int64_t way = int64_t{rest_urad} - lost.from_urad[j];
      joint.target_urad = static_cast<slongword>(lost.from_urad[j] + way * step / kMoveFrames);
    }
  }
}

void SafePosture::HashState(Hasher* hasher) const {
  for (const LostCommander& lost : lost_commanders_) {
    hasher->Add(lost.commander);
    hasher->Add(lost.since);
    for (const slongword urad : lost.from_urad) hasher->Add(urad);
  }
}

}  // namespace openr_host
