// Writes and reads the bytes of trace files: little-endian numbers of fixed and of variable length.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace openr_host {

class ByteWriter {
 public:
  void U8(uint8_t value) { bytes_.push_back(static_cast<char>(value)); }
  void U32(uint32_t value) { Fixed(value, 4); }
  void U64(uint64_t value) { Fixed(value, 8); }
  // Writes a number with seven bits per byte, the lowest bits first, so that small numbers take few
  // bytes.
  void Varint(uint64_t value);
  // Writes a number that may be negative, so that small numbers of either sign take few bytes: 0,
  // -1, 1, -2 become 0, 1, 2, 3.
  void Zigzag(int64_t value) {
    Varint(static_cast<uint64_t>(value) << 1 ^ static_cast<uint64_t>(value >> 63));
  }
  void Text(std::string_view text);  // writes the length, then the bytes of the text

  const std::string& bytes() const { return bytes_; }
  void Clear() { bytes_.clear(); }

 private:
  void Fixed(uint64_t value, int count);
  std::string bytes_;
};

// Reads what a ByteWriter has written.  Throws std::runtime_error when the bytes end too early, or
// when a number of variable length has more than ten bytes, which are enough for 64 bits.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  bool AtEnd() const { return at_ == bytes_.size(); }
  size_t at() const { return at_; }
  uint8_t U8();
  uint32_t U32() { return static_cast<uint32_t>(Fixed(4)); }
  uint64_t U64() { return Fixed(8); }
  uint64_t Varint();
  int64_t Zigzag();
  std::string_view Text();

 private:
  uint64_t Fixed(int count);
  std::string_view Take(uint64_t count);

  std::string_view bytes_;
  size_t at_ = 0;
};

}  // namespace openr_host
