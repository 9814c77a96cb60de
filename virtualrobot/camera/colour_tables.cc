#include "virtualrobot/camera/colour_tables.h"

#include <bit>

#include "runtime/base/hasher.h"

namespace openr_host {
namespace {

// Sets one bit in the elements `min` to `max` of `bits`, and clears this bit in all other elements.
// `mask` is the value of a byte in which only this bit is set.
void Mark(std::array<uint8_t, 256>* bits, uint8_t mask, longword min, longword max) {
  for (longword value = 0; value < 256; ++value) {
    uint8_t& channels = (*bits)[value];
    channels =
        static_cast<uint8_t>(min <= value && value <= max ? channels | mask : channels & ~mask);
  }
}

}  // namespace

bool ColourTables::Set(const OCdtInfo& info) {
  if (!std::has_single_bit(info.channel) || info.channel > ocdtCHANNEL7) return false;
  const auto mask = static_cast<uint8_t>(info.channel);
  for (size_t segment = 0; segment < ocdtMAX_Y_SEGMENT; ++segment) {
    const longword packed = info.table[segment];
    // Replaces ocdtINIT, which means that the segment of a colour table detects no colour, by the
    // empty range from 1 to 0, because ocdtINIT, read as a rectangle of Cr and Cb, would detect
    // neutral grey.
    const bool unused = packed == ocdtINIT;
    Mark(&cr_[segment], mask, unused ? 1 : packed & 0xff, unused ? 0 : packed >> 8 & 0xff);
    Mark(&cb_[segment], mask, unused ? 1 : packed >> 16 & 0xff, unused ? 0 : packed >> 24);
  }
  used_ |= mask;
  return true;
}

void ColourTables::HashState(Hasher* hasher) const {
  hasher->Add(used_);
  if (empty()) return;
  hasher->AddBytes(&cr_, sizeof cr_);
  hasher->AddBytes(&cb_, sizeof cb_);
}

}  // namespace openr_host
