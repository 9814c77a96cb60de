// The fuzz target motion_csv: motions as CSV.
#include <stdexcept>

#include "MtnFile.h"
#include "openr/motion/mtn_csv.h"
#include "openr/motion/mtn_writer.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::motion_csv(std::string_view bytes) {
  try {
    const MotionFile motion = ParseMotionCsv(std::string(bytes));
    const std::vector<uint8_t> written = WriteMtn(motion);
    MtnFile read;
    FuzzCheck(read.Read(written.data(), written.size()), "a written motion is read");
    return motion.key_frames.size() > 2 && motion.key_frames[1].interpolation > 40;
  } catch (const std::runtime_error&) {
  } catch (const std::invalid_argument&) {
  }
  return false;
}

}  // namespace openr_host
