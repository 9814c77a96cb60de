// The fuzz target mtn: motion files (MTN), on all robots.
#include "MtnFile.h"
#include "RobotConstants.h"
#include "openr/motion/mtn_csv.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::mtn(std::string_view bytes) {
  MtnFile motion;
  if (!motion.Read(reinterpret_cast<const Uint8*>(bytes.data()), bytes.size())) {
    FuzzCheck(!motion.Error().empty() && motion.NumKeyFrames() == 0, "a refused motion is empty");
    return false;
  }
  FuzzCheck(motion.DurationMs() >= 0, "a duration");
  CsvOf(motion);
  for (const RobotConstants& robot : ROBOTS) motion.MapTo(&robot);
  return motion.NumKeyFrames() == 2 && motion.Interpolation(0) > 200;
}

}  // namespace openr_host
