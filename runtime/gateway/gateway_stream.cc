#include "runtime/gateway/gateway_stream.h"

#include <OPENR/ObjcommTypes.h>
#include <fmt/format.h>

#include <utility>

namespace openr_host {
namespace {

constexpr size_t kWordBytes = 4;

}  // namespace

std::string EncodeWord(uint32_t word) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xff);
  return bytes;
}

std::string EncodeSet(const GatewaySet& set) {
  std::string rest = EncodeWord(static_cast<uint32_t>(set.size()));
  for (const std::string& item : set) {
    rest += EncodeWord(static_cast<uint32_t>(item.size()));
    rest += item;
  }
  return EncodeWord(static_cast<uint32_t>(rest.size())) + rest;
}

uint32_t GatewayStream::WordAt(size_t offset) const {
  uint32_t word = 0;
  for (size_t i = 0; i < kWordBytes; ++i)
    word |= static_cast<uint32_t>(static_cast<unsigned char>(bytes_[offset + i])) << (8 * i);
  return word;
}

GatewayStream::Result GatewayStream::Break(std::string why) {
  error_ = std::move(why);
  return Result::kBroken;
}

GatewayStream::Result GatewayStream::NextWord(uint32_t* word) {
  if (bytes_.size() < kWordBytes) return Result::kNeedsMore;
  *word = WordAt(0);
  bytes_.erase(0, kWordBytes);
  return Result::kTaken;
}

GatewayStream::Result GatewayStream::NextSet(GatewaySet* set) {
  set->clear();
  if (bytes_.size() < kWordBytes) return Result::kNeedsMore;
  const size_t size = WordAt(0);
  if (size > kGatewaySetBytesMax)
    return Break(fmt::format("announces {} bytes, the limit is {}", size, kGatewaySetBytesMax));
  if (size < 2 * kWordBytes + 1)
    return Break(fmt::format("announces {} bytes, which no set of data has", size));
  if (bytes_.size() < kWordBytes + size) return Result::kNeedsMore;
  const uint32_t count = WordAt(kWordBytes);
  if (count < 1 || count > MAX_NUM_DATA)
    return Break(fmt::format("announces {} items; a notification has 1 to {}", count,
                             static_cast<int>(MAX_NUM_DATA)));
  size_t at = 2 * kWordBytes;
  const size_t end = kWordBytes + size;
  for (uint32_t i = 0; i < count; ++i) {
    const size_t left = end - at;
    const size_t bytes = left < kWordBytes ? 0 : WordAt(at);
    if (bytes == 0 || bytes > left - kWordBytes)
      return Break(fmt::format("item {} of {} has {} bytes, {} are left", i + 1, count, bytes,
                               left < kWordBytes ? 0 : left - kWordBytes));
    set->push_back(bytes_.substr(at + kWordBytes, bytes));
    at += kWordBytes + bytes;
  }
  if (at != end) return Break(fmt::format("{} bytes are left after the last item", end - at));
  bytes_.erase(0, end);
  return Result::kTaken;
}

}  // namespace openr_host
