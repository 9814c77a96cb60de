// The first bytes of images (.BIN), for tests of what is done with them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "ImageFile.h"

namespace openr_host {

using Bytes = std::vector<uint8_t>;

// `size` bytes that begin with an ELF header; `class_bits` is 1 for 32 bits and 2 for 64.
inline Bytes Image(int class_bits, int machine, size_t size = 3000) {
  Bytes bytes(size, 7);
  const Bytes head = {0x7f, 'E', 'L', 'F', static_cast<uint8_t>(class_bits), 1, 1};
  std::copy(head.begin(), head.end(), bytes.begin());
  bytes[18] = static_cast<uint8_t>(machine);
  bytes[19] = 0;
  return bytes;
}
// An image for the processor that runs this test, and one for another processor.
inline Bytes OwnImage() { return OwnProcessor() == imageMIPS ? Image(1, 8) : Image(2, 62); }
inline Bytes OtherImage() { return OwnProcessor() == imageMIPS ? Image(2, 62) : Image(1, 8); }

}  // namespace openr_host
