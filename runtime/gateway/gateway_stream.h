// The bytes between two gateways, as measured (measured.md, "TCPGateway wire format").
//
// All words have 32 bits, little-endian.  With the data: byte count of the rest, number of items,
// then each item's size and bytes.  Against the data: one word a time, ready or not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// What one notification carries.
using GatewaySet = std::vector<std::string>;

inline constexpr uint32_t kGatewayAssert = 3;
inline constexpr uint32_t kGatewayDeassert = 4;  // by its header; not tried

// Ours, to bound what a peer can make us keep: the largest image of a robot fits twice.
inline constexpr uint32_t kGatewaySetBytesMax = 1 << 20;

std::string EncodeWord(uint32_t word);
std::string EncodeSet(const GatewaySet& set);

// What came in of a stream and was not taken yet.
class GatewayStream {
 public:
  enum class Result { kNeedsMore, kTaken, kBroken };

  void Feed(std::string_view bytes) { bytes_.append(bytes); }

  // The next word, or the next whole set.  kBroken: the stream cannot be read on, error() says
  // why.  Nothing that is announced is believed before it is bounded.
  Result NextWord(uint32_t* word);
  Result NextSet(GatewaySet* set);

  const std::string& error() const { return error_; }
  const std::string& bytes() const { return bytes_; }

 private:
  uint32_t WordAt(size_t offset) const;
  Result Break(std::string why);

  std::string bytes_;
  std::string error_;
};

}  // namespace openr_host
