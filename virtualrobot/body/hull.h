// Hull: the balls and boxes of a robot, and the lowest point of all of them.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "virtualrobot/model/robot_model.h"

namespace openr_host {

// Returns X * p.  Leaves out the fourth row of X, because it is always 0, 0, 0, 1.
inline Eigen::Vector3d Moved(const Eigen::Isometry3d& X, const Eigen::Vector3d& p) {
  return X.linear() * p + X.translation();
}

// The convex hull of a robot: the paws, which are balls, and the boxes of the parts.  All
// coordinates are in the base frame B.
class Hull {
 public:
  // Makes the hull of `model`.  Move() must be called for each part before the first call of
  // LowestAlong().
  explicit Hull(const RobotModel& model);

  // Moves the ball and the box of part `part` (index of RobotModel::bodies) to the pose `X_BL`.
  void Move(int part, const Eigen::Isometry3d& X_BL);

  // Returns the lowest point of the hull.  The height of a point is its scalar product with `n_B`.
  // Compares the corners of the boxes and one point of each ball: the point that is lowest along
  // `up_B`, a unit vector near n_B.
  Eigen::Vector3d LowestAlong(const Eigen::Vector3d& n_B, const Eigen::Vector3d& up_B) const;

  // Returns the centre of the ball of paw `paw` (index of RobotModel::paws), in the base frame B.
  const Eigen::Vector3d& PawCentre(size_t paw) const { return balls_[paw].centre; }

 private:
  // A vector of two numbers.  Every x86-64 processor can compute with both numbers in one
  // instruction.
  using Pair = double __attribute__((vector_size(16)));

  struct Ball {
    Eigen::Vector3d centre;
    double radius;
    int part;
  };
  struct Box {
    Eigen::Vector3d centre;
    Eigen::Matrix3d half_edges;  // matrix whose columns are half the edges of the box
    int part;
  };
  // Two balls, each of which encloses one box: element i of around_ has the balls of the boxes 2i
  // and 2i + 1 of boxes_.  LowestAlong() looks at a box only if the ball of the box reaches lower
  // than the lowest point found so far.
  struct BallPair {
    Pair x{}, y{}, z{};  // coordinates of the balls' centres
    // The radii of the two balls.  If the number of boxes is odd, the second ball of the last
    // BallPair has no box, and its radius stays minus infinity.  The lowest point of this ball
    // (height of the centre minus radius) is then infinitely high, so LowestAlong() never looks for
    // the missing box.
    Pair radius = {-std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
  };

  static void StoreIfLower(const Box& box, const Eigen::Vector3d& n_B, double* best,
                           Eigen::Vector3d* lowest);

  const RobotModel* model_;
  std::vector<Ball> balls_;  // balls of the paws, in the order of RobotModel::paws
  std::vector<Box> boxes_;   // boxes of the parts, in the order of RobotModel::bodies
  std::vector<BallPair> around_;
};

}  // namespace openr_host
