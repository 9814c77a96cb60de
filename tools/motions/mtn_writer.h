// The write side of a motion file (MTN), as objects/common/MtnFile.h reads it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host::motions {

struct KeyFrame {
  int interpolation = 0;             // frames before it; of the first: unused
  double pitch_rad = 0;              // of the body, nose up positive; players ignore it
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

}  // namespace openr_host::motions
