#include "openr/motion/mtn_writer.h"

#include <fmt/format.h>

#include <stdexcept>

namespace openr_host {
namespace {

constexpr int kMtnFrameMs = 16;

class MtnSection {
 public:
  explicit MtnSection(uint32_t number) {
    U32(number);
    U32(0);  // placeholder for the size of the section, which Finish() fills in
  }
  void U8(uint32_t value) { bytes_.push_back(static_cast<uint8_t>(value)); }
  void U16(uint32_t value) {
    U8(value & 0xff);
    U8(value >> 8 & 0xff);
  }
  void U32(uint32_t value) {
    U16(value & 0xffff);
    U16(value >> 16);
  }
  void String(const std::string& text) {
    if (text.size() > 255)
      throw std::invalid_argument(fmt::format("'{}' has more than 255 characters", text));
    U8(static_cast<uint32_t>(text.size()));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }
  // Pads this section of a motion file with zeros to a multiple of 4 bytes, writes its size into it
  // and appends it to `out`.
  void Finish(std::vector<uint8_t>* out) {
    while (bytes_.size() % 4 != 0) bytes_.push_back(0);
    for (int i = 0; i < 4; ++i) bytes_[4 + i] = static_cast<uint8_t>(bytes_.size() >> 8 * i);
    out->insert(out->end(), bytes_.begin(), bytes_.end());
  }

 private:
  std::vector<uint8_t> bytes_;
};

void WriteKeyFrame(const KeyFrame& frame, bool first, MtnSection* section) {
  if (!first) section->U32(static_cast<uint32_t>(frame.interpolation));
  for (const int32_t angle : frame.attitude_urad) section->U32(static_cast<uint32_t>(angle));
  for (const int32_t angle : frame.angles_urad) section->U32(static_cast<uint32_t>(angle));
}

}  // namespace

std::vector<uint8_t> WriteMtn(const MotionFile& motion) {
  std::vector<uint8_t> out{'O', 'M', 'T', 'N'};
  MtnSection header(0);
  header.U32(4);
  header.U16(1);
  header.U16(2);
  header.U16(static_cast<uint32_t>(motion.key_frames.size()));
  header.U16(kMtnFrameMs);
  header.U32(0);
  header.Finish(&out);

  MtnSection names(1);
  for (const std::string& name : {motion.name, motion.creator, motion.design_label})
    names.String(name);
  names.Finish(&out);

  MtnSection joints(2);
  joints.U16(static_cast<uint32_t>(motion.locators.size()));
  for (const std::string& locator : motion.locators) joints.String(locator);
  joints.Finish(&out);

  MtnSection data(3);
  data.U32(0);  // the type of the data; 0 is the type of angles
  for (size_t k = 0; k < motion.key_frames.size(); ++k) {
    if (motion.key_frames[k].angles_urad.size() != motion.locators.size()) {
      throw std::invalid_argument(
          fmt::format("'{}': key frame {} has {} angles for {} joints", motion.name, k,
                      motion.key_frames[k].angles_urad.size(), motion.locators.size()));
    }
    WriteKeyFrame(motion.key_frames[k], k == 0, &data);
  }
  data.Finish(&out);
  return out;
}

}  // namespace openr_host
