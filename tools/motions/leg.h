// A leg in its own plane: J1 and J3 move the paw, J2 stays 0.
//
// Coordinates are in millimetres and seen from the J1 axis: `out` is the distance away from the
// middle of the body (forward for a fore leg, rearward for a hind leg), `up` the height.  Positive
// angles of both joints move the paw outward, on all four legs (docs/openr/ers210.md, section 2).
#pragma once

#include <string>

namespace openr_host::motions {

struct LegPoint {
  double out = 0, up = 0;
};

struct LegAngles {
  double j1_rad = 0, j3_rad = 0;
};

class Leg {
 public:
  // `knee` and `paw` (the centre of its ball) are places in the model at zero angles: `knee` seen
  // from the J1 axis, `paw` seen from the knee.
  Leg(const LegPoint& knee, const LegPoint& paw) : knee_(knee), paw_(paw) {}

  LegPoint Paw(const LegAngles& angles) const;

  // Returns the angles that bring the paw to `target`, with the knee bent outward.  Throws
  // std::domain_error, with `what`, if the paw cannot reach `target`.
  LegAngles Reach(const LegPoint& target, const std::string& what) const;

 private:
  LegPoint knee_, paw_;
};

}  // namespace openr_host::motions
