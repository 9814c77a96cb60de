// Motion files made in memory, byte by byte and independent of the generator in tools/, so
// that tests can also make wrong ones.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host {

// Plain data; Bytes() writes what it says, right or wrong.
struct MtnBytes {
  std::string magic = "OMTN";
  std::string name = "a_stand#test";
  std::string creator = "openr-host tests";
  std::string label = "DRX-900";
  uint32_t sections = 4;
  uint16_t major = 1, minor = 2;
  uint16_t rate_ms = 16;
  uint32_t data_type = 0;
  std::vector<std::string> locators;
  struct KeyFrame {
    uint32_t interpolation = 0;  // frames before this key frame; not written for the first
    std::vector<int32_t> angles_urad;
    int32_t roll = 0, pitch = 0, yaw = 0;
  };
  std::vector<KeyFrame> key_frames;

  // Overrides; -1: the true value.
  int64_t key_frame_count = -1;
  int64_t joint_count = -1;
  int64_t section_size[4] = {-1, -1, -1, -1};
  int64_t section_number[4] = {-1, -1, -1, -1};

  std::vector<uint8_t> Bytes() const;
  static MtnBytes OneJoint(const std::string& locator, const std::vector<int32_t>& angles_urad,
                           uint32_t interpolation = 0);
};

inline void Append16(std::vector<uint8_t>* out, uint32_t v) {
  out->push_back(v & 0xff);
  out->push_back((v >> 8) & 0xff);
}
inline void Append32(std::vector<uint8_t>* out, uint32_t v) {
  Append16(out, v & 0xffff);
  Append16(out, v >> 16);
}
inline void AppendString(std::vector<uint8_t>* out, const std::string& s) {
  out->push_back(static_cast<uint8_t>(s.size()));
  out->insert(out->end(), s.begin(), s.end());
}

inline MtnBytes MtnBytes::OneJoint(const std::string& locator,
                                   const std::vector<int32_t>& angles_urad,
                                   uint32_t interpolation) {
  MtnBytes mtn;
  mtn.locators = {locator};
  for (const int32_t angle : angles_urad) mtn.key_frames.push_back({interpolation, {angle}});
  return mtn;
}

inline std::vector<uint8_t> MtnBytes::Bytes() const {
  std::vector<uint8_t> body[4];
  Append32(&body[0], sections);
  Append16(&body[0], major);
  Append16(&body[0], minor);
  Append16(&body[0], key_frame_count >= 0 ? key_frame_count : key_frames.size());
  Append16(&body[0], rate_ms);
  Append32(&body[0], 0);
  for (const std::string& text : {name, creator, label}) AppendString(&body[1], text);
  Append16(&body[2], joint_count >= 0 ? joint_count : locators.size());
  for (const std::string& locator : locators) AppendString(&body[2], locator);
  Append32(&body[3], data_type);
  for (size_t k = 0; k < key_frames.size(); ++k) {
    if (k > 0) Append32(&body[3], key_frames[k].interpolation);
    for (const int32_t axis : {key_frames[k].roll, key_frames[k].pitch, key_frames[k].yaw})
      Append32(&body[3], axis);
    for (const int32_t angle : key_frames[k].angles_urad) Append32(&body[3], angle);
  }
  std::vector<uint8_t> out(magic.begin(), magic.end());
  for (int s = 0; s < 4; ++s) {
    while (body[s].size() % 4 != 0) body[s].push_back(0);
    Append32(&out, section_number[s] >= 0 ? section_number[s] : s);
    Append32(&out, section_size[s] >= 0 ? section_size[s] : body[s].size() + 8);
    out.insert(out.end(), body[s].begin(), body[s].end());
  }
  return out;
}

}  // namespace openr_host
