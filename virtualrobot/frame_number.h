// The frame number: a count of frames of 8 ms, in which all data of the robot are dated.
#pragma once

#include <OPENR/OPENR.h>

#include <cstdint>

namespace openr_host {

// The number that commands, sensors, images and sound carry for the `frame`-th frame since
// boot.  After oframeMAX_NUMBER comes 0; it is not known whether the robot continues with 0 or 1.
inline longword FrameNumber(int64_t frame) {
  return static_cast<longword>(frame % (int64_t{oframeMAX_NUMBER} + 1));
}

}  // namespace openr_host
