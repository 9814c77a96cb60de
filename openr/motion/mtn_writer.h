// The write side of a motion file (MTN), as objects/common/MtnFile.h reads it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace openr_host {

struct KeyFrame {
  int interpolation = 0;  // number of interpolated frames before it; unused in the first
  // Roll, pitch and yaw of the body; pitch is positive with the nose up.  Players ignore them.
  std::array<int32_t, 3> attitude_urad{};
  std::vector<int32_t> angles_urad;  // order of MotionFile::locators
};

struct MotionFile {
  std::string name;  // "stand#sit"
  std::string creator = "openr-host";
  std::string design_label = "DRX-900";  // ERS-210 and ERS-220
  std::vector<std::string> locators;
  std::vector<KeyFrame> key_frames;
};

// Version 1.2, four sections, 16 ms, little-endian.  Throws std::invalid_argument when a key
// frame has not one angle per locator or a string is longer than its length byte can say.
std::vector<uint8_t> WriteMtn(const MotionFile& motion);

}  // namespace openr_host
