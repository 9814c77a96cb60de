// The one counter of the robot: frames of 8 ms since boot.
#pragma once

#include <OPENR/OPENR.h>

#include <cstdint>

namespace openr_host {

// The number that commands, sensors, images and sound carry for the `frame`-th frame since
// boot.  It begins anew after oframeMAX_NUMBER, at 0 (the robot's choice between 0 and
// 1 is not known).
inline longword FrameNumber(int64_t frame) {
  return static_cast<longword>(frame % (int64_t{oframeMAX_NUMBER} + 1));
}

}  // namespace openr_host
