// Writes motion files (MTN), which objects/common/MtnFile.h reads.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace openr_host {

struct KeyFrame {
  // Number of interpolated frames before this key frame; unused in the first key frame.
  int interpolation = 0;
  // Roll, pitch and yaw of the body; pitch is positive with the nose up.  Programs that play the
  // motion ignore these angles.
  std::array<int32_t, 3> attitude_urad{};
  std::vector<int32_t> angles_urad;  // angles of the joints, in the order of MotionFile::locators
};

struct MotionFile {
  std::string name;  // name of the motion, such as "stand#sit"
  std::string creator = "openr-host";
  std::string design_label = "DRX-900";  // the label of ERS-210 and ERS-220
  std::vector<std::string> locators;
  std::vector<KeyFrame> key_frames;
};

// Returns a motion file of version 1.2 with four sections, 16 ms frames and little-endian numbers.
// Throws std::invalid_argument if a key frame does not have one angle per locator, or if a string
// is too long for its length byte.
std::vector<uint8_t> WriteMtn(const MotionFile& motion);

}  // namespace openr_host
