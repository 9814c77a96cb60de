// The frame number: a count of frames of 8 ms, by which all data of the robot are dated.
#pragma once

#include <OPENR/OPENR.h>

#include <cstdint>

namespace openr_host {

// Returns the number that commands, sensor values, images and sounds carry for frame `frame`, which
// counts from boot.  oframeMAX_NUMBER is followed by 0; it is not known whether the robot continues
// with 0 or 1.
inline longword FrameNumber(int64_t frame) {
  return static_cast<longword>(frame % (int64_t{oframeMAX_NUMBER} + 1));
}

}  // namespace openr_host
