// ColourTables: the colour detection of the camera (robot.md, 11.3).  A colour table describes one
// colour to detect: for each of 32 segments of luminance, it has a rectangle of Cr and Cb.  There
// are eight tables, one for each channel.  A pixel of the result is a byte; its bit k says whether
// the pixel matches the table of channel k.
#pragma once

#include <OPENR/ODataFormats.h>

#include <array>
#include <cstdint>
#include <string>

namespace openr_host {

class Hasher;

class ColourTables {
 public:
  // Sets the colour table of the channel that `info.channel` names.  Returns false when
  // `info.channel` is not the constant of exactly one channel.
  bool Set(const OCdtInfo& info);

  bool empty() const { return used_ == 0; }

  // Returns a byte in which bit k is set when a pixel with the values `y`, `cr` and `cb` matches
  // the colour table of channel k.
  uint8_t Detect(uint8_t y, uint8_t cr, uint8_t cb) const {
    const size_t segment = y / (256 / ocdtMAX_Y_SEGMENT);
    return cr_[segment][cr] & cb_[segment][cb];
  }

  void HashState(Hasher* hasher) const;

 private:
  // The ranges of Cr, or of Cb, of all channels.  Bit k of element [segment][value] is set when the
  // range of channel k in this segment of luminance contains `value`.
  using Bits = std::array<std::array<uint8_t, 256>, ocdtMAX_Y_SEGMENT>;
  Bits cr_{};
  Bits cb_{};
  uint8_t used_ = 0;  // bit k is set when channel k has a colour table
};

}  // namespace openr_host
