// One leg in its own plane: J1 and J3 move the paw, J2 stays 0.
//
// Coordinates are those of the leg, seen from the J1 axis: `out` away from the middle of the
// body (forward for a fore leg, rearward for a hind leg) and `up`; millimetres.  Positive angles
// of both joints move the paw outward, on all four legs (docs/openr/ers210.md, section 2).
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
  // `knee` and `paw` (the centre of its ball) are those of the model at zero angles; the
  // paw is given from the knee.
  Leg(const LegPoint& knee, const LegPoint& paw) : knee_(knee), paw_(paw) {}

  LegPoint Paw(const LegAngles& angles) const;

  // The angles that bring the paw to `target`, knee bent outward.  Throws std::domain_error
  // naming `what` when it is out of reach.
  LegAngles Reach(const LegPoint& target, const std::string& what) const;

 private:
  LegPoint knee_, paw_;
};

}  // namespace openr_host::motions
