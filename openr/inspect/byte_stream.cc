#include "openr/inspect/byte_stream.h"

#include <algorithm>

namespace openr_host {

// Makes the memory for the bytes at least twice as large.  Each growth copies all bytes, so growth
// in small steps would copy them too often.
void ByteWriter::Grow(size_t count) { bytes_.resize(std::max(2 * bytes_.size(), size_ + count)); }

void ByteWriter::Text(std::string_view text) {
  char* const out = PutVarint(text.size(), Room(kVarintBytesMax + text.size()));
  SetEnd(std::copy(text.begin(), text.end(), out));
}

std::string_view ByteReader::Bytes(uint64_t count) {
  if (count > bytes_.size() - at_) throw std::runtime_error("the data end too early");
  at_ += count;
  return bytes_.substr(at_ - count, count);
}

uint64_t ByteReader::Fixed(int count) {
  uint64_t value = 0;
  int shift = 0;
  for (const char c : Bytes(static_cast<uint64_t>(count))) {
    value |= uint64_t{static_cast<uint8_t>(c)} << shift;
    shift += 8;
  }
  return value;
}

uint8_t ByteReader::U8() { return static_cast<uint8_t>(Bytes(1)[0]); }

uint64_t ByteReader::Varint() {
  uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const uint8_t byte = U8();
    value |= uint64_t{byte & 0x7fu} << shift;
    if (byte < 0x80) return value;
  }
  throw std::runtime_error("a number has more than ten bytes");
}

int64_t ByteReader::Zigzag() {
  const uint64_t value = Varint();
  return static_cast<int64_t>(value >> 1 ^ (~(value & 1) + 1));
}

std::string_view ByteReader::Text() { return Bytes(Varint()); }

}  // namespace openr_host
