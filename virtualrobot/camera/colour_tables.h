// Colour detection (robot.md, 11.3).  A table is a colour: for each of 32 segments of luminance it
// has a rectangle of Cr and Cb.  There are eight tables, called channels, and a pixel gets one bit
// for each.
#pragma once

#include <OPENR/ODataFormats.h>

#include <array>
#include <cstdint>
#include <string>

namespace openr_host {

class Hasher;

class ColourTables {
 public:
  // Sets the table of one channel.  Returns false when `info.channel` is not exactly one channel.
  bool Set(const OCdtInfo& info);

  bool empty() const { return used_ == 0; }

  // Bit k is set when the pixel falls into the table of channel k.
  uint8_t Detect(uint8_t y, uint8_t cr, uint8_t cb) const {
    const size_t segment = y / (256 / ocdtMAX_Y_SEGMENT);
    return cr_[segment][cr] & cb_[segment][cb];
  }

  void HashState(Hasher* hasher) const;

 private:
  // [segment][value]: bits of the channels whose range contains the value.
  using Bits = std::array<std::array<uint8_t, 256>, ocdtMAX_Y_SEGMENT>;
  Bits cr_{};
  Bits cb_{};
  uint8_t used_ = 0;  // bits of the channels that have a table
};

}  // namespace openr_host
