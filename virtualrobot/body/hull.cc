#include "virtualrobot/body/hull.h"

#include <cmath>
#include <limits>

namespace openr_host {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Factor that makes the ball around a box slightly larger than the smallest ball that encloses the
// box.  LowestAlong() skips a box if its ball does not reach lower than the lowest point found so
// far.  Because the balls grow by far more than all errors of rounding, LowestAlong() never skips
// the box that has the lowest point.
constexpr double kBallFactor = 1 + 1e-9;

}  // namespace

Hull::Hull(const RobotModel& model) : model_(&model) {
  for (const Paw& paw : model.paws) balls_.push_back({paw.centre_m, paw.radius_m, paw.body});
  for (size_t i = 0; i < model.bodies.size(); ++i) {
    const BodyPart& body = model.bodies[i];
    if (!body.has_box) continue;
    const Vector3d half_m = body.size_m / 2;
    const size_t pair = boxes_.size() / 2, half = boxes_.size() % 2;
    boxes_.push_back({body.centre_m, half_m.asDiagonal(), static_cast<int>(i)});
    if (half == 0) around_.emplace_back();
    around_[pair].radius[half] = half_m.norm() * kBallFactor;
  }
}

void Hull::Move(int part, const Isometry3d& X_BL) {
  for (size_t i = 0; i < balls_.size(); ++i) {
    if (balls_[i].part == part) balls_[i].centre = Moved(X_BL, model_->paws[i].centre_m);
  }
  const BodyPart& body = model_->bodies[static_cast<size_t>(part)];
  if (!body.has_box) return;
  for (size_t i = 0; i < boxes_.size(); ++i) {
    Box& box = boxes_[i];
    if (box.part != part) continue;
    box.centre = Moved(X_BL, body.centre_m);
    box.half_edges = X_BL.linear() * (body.size_m / 2).asDiagonal();
    around_[i / 2].x[i % 2] = box.centre.x();
    around_[i / 2].y[i % 2] = box.centre.y();
    around_[i / 2].z[i % 2] = box.centre.z();
  }
}

// Finds the lowest corner of `box`.  The height of a point is its scalar product with `n_B`.  If
// the corner is lower than `best`, stores the corner in `lowest` and its height in `best`.
void Hull::StoreIfLower(const Box& box, const Vector3d& n_B, double* best, Vector3d* lowest) {
  const Vector3d reach = box.half_edges.transpose() * n_B;
  const double height =
      n_B.dot(box.centre) - (std::fabs(reach.x()) + std::fabs(reach.y()) + std::fabs(reach.z()));
  if (height >= *best) return;
  *best = height;
  const Vector3d side(reach.x() > 0 ? -1 : 1, reach.y() > 0 ? -1 : 1, reach.z() > 0 ? -1 : 1);
  *lowest = box.centre + box.half_edges * side;
}

Vector3d Hull::LowestAlong(const Vector3d& n_B, const Vector3d& up_B) const {
  double best = std::numeric_limits<double>::infinity();
  Vector3d lowest = Vector3d::Zero();
  for (const Ball& ball : balls_) {
    const Vector3d p = ball.centre - ball.radius * up_B;
    const double height = n_B.dot(p);
    if (height < best) best = height, lowest = p;
  }
  const double n_norm = n_B.norm();
  for (size_t i = 0; i < around_.size(); ++i) {
    // Compares the lowest points of the balls around the boxes first, because most boxes are so far
    // above the paws that their exact height is not needed.
    const BallPair& pair = around_[i];
    const Pair bottom =
        pair.x * n_B.x() + pair.y * n_B.y() + pair.z * n_B.z() - pair.radius * n_norm;
    for (size_t half = 0; half < 2; ++half) {
      if (bottom[half] < best) StoreIfLower(boxes_[2 * i + half], n_B, &best, &lowest);
    }
  }
  return lowest;
}

}  // namespace openr_host
