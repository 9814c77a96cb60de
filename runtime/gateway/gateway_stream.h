// Encodes and decodes the bytes between two gateways, as measured on Sony's gateway (measured.md,
// "TCPGateway wire format").
//
// All words have 32 bits, little-endian.  A set (the data of one notification) goes from the
// subject's side to the observer's side: the number of bytes that follow, the number of items, then
// the size and bytes of each item.  A single word goes from the observer's side to the subject's
// side: it asserts ready (kGatewayAssert) or takes the ready back (kGatewayDeassert).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// The data of one notification of a subject: one string for each data item that SetData() has
// added.
using GatewaySet = std::vector<std::string>;

inline constexpr uint32_t kGatewayAssert = 3;
inline constexpr uint32_t kGatewayDeassert = 4;  // value of the SDK; not measured on a robot

// Our own limit for the size of a set (the data of one notification), which bounds the memory that
// a peer can make us use.  Two of the largest camera images of a robot fit into a set.
inline constexpr uint32_t kGatewaySetBytesMax = 1 << 20;

std::string EncodeWord(uint32_t word);
std::string EncodeSet(const GatewaySet& set);

// Decodes the stream of bytes that the gateway of another computer sends.  Keeps the bytes that
// were received but not decoded yet.
class GatewayStream {
 public:
  enum class Result { kNeedsMore, kTaken, kBroken };

  void Feed(std::string_view bytes) { bytes_.append(bytes); }

  // Removes the next 32-bit word from the bytes that were received from the peer, the gateway of
  // another computer.  Returns kNeedsMore if the word has not arrived completely.
  Result NextWord(uint32_t* word);
  // Removes the next whole set (the data of one notification) from the bytes that were received
  // from the peer, the gateway of another computer.  Returns kNeedsMore if the set has not arrived
  // completely.  Returns kBroken if the rest of the stream cannot be decoded; error() then returns
  // the reason.  Sizes in the stream are checked against limits before they are used.
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
