// Writes and reads the bytes of trace files: little-endian numbers of fixed and of variable length.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace openr_host {

class ByteWriter {
 public:
  // The largest number of bytes that PutVarint() writes: 10 bytes with 7 bits each hold a number of
  // 64 bits.
  static constexpr size_t kVarintBytesMax = 10;

  void U8(uint8_t value) { Fixed(value, 1); }
  void U32(uint32_t value) { Fixed(value, 4); }
  void U64(uint64_t value) { Fixed(value, 8); }
  // Writes a number with seven of its bits in each byte, the lowest bits first.  So small numbers
  // take few bytes.
  void Varint(uint64_t value) { SetEnd(PutVarint(value, Room(kVarintBytesMax))); }
  void Zigzag(int64_t value) { Varint(Folded(value)); }
  void Text(std::string_view text);  // writes the length, then the bytes of the text

  // Returns a pointer to room for `count` bytes behind the bytes written so far.  The caller writes
  // bytes into this room, and then passes the end of its bytes to SetEnd().  So the free room is
  // checked only once for many numbers.
  char* Room(size_t count) {
    if (count > bytes_.size() - size_) Grow(count);
    return bytes_.data() + size_;
  }
  void SetEnd(const char* end) { size_ = static_cast<size_t>(end - bytes_.data()); }

  // PutVarint(), PutZigzag() and PutFixed() write a number to `out` and return a pointer to the
  // first byte behind the number.
  static char* PutVarint(uint64_t value, char* out) {
    for (; value >= 0x80; value >>= 7) *out++ = static_cast<char>(value | 0x80);
    *out++ = static_cast<char>(value);
    return out;
  }
  // Writes a number that may be negative, so that small numbers of either sign take few bytes: 0,
  // -1, 1, -2 become 0, 1, 2, 3.
  static char* PutZigzag(int64_t value, char* out) { return PutVarint(Folded(value), out); }
  static char* PutFixed(uint64_t value, size_t count, char* out) {
    if constexpr (std::endian::native == std::endian::little) {
      std::memcpy(out, &value, count);
      return out + count;
    }
    for (size_t i = 0; i < count; ++i) *out++ = static_cast<char>(value >> 8 * i);
    return out;
  }

  std::string_view bytes() const { return std::string_view(bytes_).substr(0, size_); }
  void Clear() { size_ = 0; }

 private:
  static uint64_t Folded(int64_t value) {
    return static_cast<uint64_t>(value) << 1 ^ static_cast<uint64_t>(value >> 63);
  }
  void Fixed(uint64_t value, size_t count) { SetEnd(PutFixed(value, count, Room(count))); }
  void Grow(size_t count);

  std::string bytes_;  // the written bytes, and behind them room for more
  size_t size_ = 0;    // number of written bytes
};

// Reads what a ByteWriter has written.  Throws std::runtime_error when the bytes end too early, or
// when a number of variable length has more than ten bytes, which are enough for 64 bits.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  bool AtEnd() const { return at_ == bytes_.size(); }
  size_t at() const { return at_; }
  uint8_t U8();
  uint16_t U16() { return static_cast<uint16_t>(Fixed(2)); }
  uint32_t U32() { return static_cast<uint32_t>(Fixed(4)); }
  uint64_t U64() { return Fixed(8); }
  uint64_t Varint();
  int64_t Zigzag();
  std::string_view Text();
  std::string_view Bytes(uint64_t count);

 private:
  uint64_t Fixed(int count);

  std::string_view bytes_;
  size_t at_ = 0;
};

}  // namespace openr_host
