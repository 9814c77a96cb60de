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
  // Writes a number with seven bits per byte, the lowest bits first.
  void Varint(uint64_t value);
  // Writes small negative numbers in few bytes: 0, -1, 1, -2 become 0, 1, 2, 3.
  void Zigzag(int64_t value) {
    Varint(static_cast<uint64_t>(value) << 1 ^ static_cast<uint64_t>(value >> 63));
  }
  void Text(std::string_view text);  // length, then the bytes

  const std::string& bytes() const { return bytes_; }
  void Clear() { bytes_.clear(); }

 private:
  void Fixed(uint64_t value, int count);
  std::string bytes_;
};

// Reads bytes of ByteWriter.  Throws std::runtime_error when the bytes end too early or a number
// has too many.
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
