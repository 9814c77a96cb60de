#include "openr/inspect/byte_stream.h"

namespace openr_host {

// The bytes of a number are collected and appended at once, because a string checks its room for
// each append.
void ByteWriter::Fixed(uint64_t value, int count) {
  char bytes[8];
  for (int i = 0; i < count; ++i) bytes[i] = static_cast<char>(value >> 8 * i);
  bytes_.append(bytes, static_cast<size_t>(count));
}

void ByteWriter::Varint(uint64_t value) {
  if (value < 0x80) return U8(static_cast<uint8_t>(value));  // nearly all numbers
  char bytes[10];
  size_t count = 0;
  for (; value >= 0x80; value >>= 7) bytes[count++] = static_cast<char>(value | 0x80);
  bytes[count++] = static_cast<char>(value);
  bytes_.append(bytes, count);
}

void ByteWriter::Text(std::string_view text) {
  Varint(text.size());
  bytes_.append(text);
}

std::string_view ByteReader::Take(uint64_t count) {
  if (count > bytes_.size() - at_) throw std::runtime_error("the data end too early");
  at_ += count;
  return bytes_.substr(at_ - count, count);
}

uint64_t ByteReader::Fixed(int count) {
  uint64_t value = 0;
  int shift = 0;
  for (const char c : Take(static_cast<uint64_t>(count))) {
    value |= uint64_t{static_cast<uint8_t>(c)} << shift;
    shift += 8;
  }
  return value;
}

uint8_t ByteReader::U8() { return static_cast<uint8_t>(Take(1)[0]); }

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

std::string_view ByteReader::Text() { return Take(Varint()); }

}  // namespace openr_host
