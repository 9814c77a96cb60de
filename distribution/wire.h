// The generated types of openr_wire.idl, with helpers for C++.
#pragma once

#include <cstdint>
#include <cstring>
#include <memory_resource>
#include <numeric>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "openr_wire.h"

namespace openr_host {

// Owns the memory that a sample points to until the sample has been written.
class WireArena {
 public:
  // Copies `items` into the memory of the arena, and returns the copy as a sequence of the
  // generated type Seq.
  template <typename Seq, typename T>
  Seq Sequence(const std::vector<T>& items) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto count = static_cast<uint32_t>(items.size());
    if (count == 0) return {};
    void* const kept = memory_.allocate(count * sizeof(T), alignof(T));
    std::memcpy(kept, items.data(), count * sizeof(T));
    return {count, count, static_cast<T*>(kept), false};
  }

  char* Text(std::string_view text) {
    static char nothing[] = "";
    // Cuts `text` at its first zero byte, because the strings of DDS end at a zero byte.
    text = text.substr(0, text.find('\0'));
    if (text.empty()) return nothing;
    auto* const kept = static_cast<char*>(memory_.allocate(text.size() + 1, 1));
    std::memcpy(kept, text.data(), text.size());
    kept[text.size()] = '\0';
    return kept;
  }

  openr_wire_Numbers Numbers(const std::vector<uint64_t>& numbers) {
    return Sequence<openr_wire_Numbers>(numbers);
  }

  openr_wire_Bytes Bytes(const void* data, size_t size) {
    if (size == 0) return {};
    void* const kept = memory_.allocate(size, 1);
    std::memcpy(kept, data, size);
    return View(kept, size);
  }

  // Returns a sequence that points to `data`, without a copy.  So `data` must stay unchanged until
  // the sample has been written.
  static openr_wire_Bytes View(const void* data, size_t size) {
    const auto count = static_cast<uint32_t>(size);
    return {count, count, static_cast<uint8_t*>(const_cast<void*>(data)), false};
  }

  void Clear() { memory_.release(); }

 private:
  char first_[1024];  // first memory of the arena; most samples fit and need no allocation
  std::pmr::monotonic_buffer_resource memory_{first_, sizeof first_};
};

inline std::vector<uint64_t> VectorOf(const openr_wire_Numbers& numbers) {
  return {numbers._buffer, numbers._buffer + numbers._length};
}
inline std::string StringOf(const openr_wire_Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes._buffer), bytes._length};
}
// Converts a string member of a sample; a null pointer becomes "".
inline std::string StringOf(const char* text) { return text == nullptr ? "" : text; }

// Returns how many bytes of memory regions a sample contains.  This version is for types of samples
// that never contain such bytes, so it returns 0.  Channel uses the number to find large samples
// (kBulkBytes).
template <typename Sample>
size_t BulkBytesOf(const Sample&) {
  return 0;
}
inline size_t BulkBytesOf(const openr_wire_Answer& answer) { return answer.bytes._length; }
// Returns how many bytes of memory regions the items of a sequence contain.  Each item has them in
// its member `bytes`.
template <typename Seq>
size_t BytesIn(const Seq& items) {
  return std::accumulate(items._buffer, items._buffer + items._length, size_t{0},
                         [](size_t sum, const auto& item) { return sum + item.bytes._length; });
}
inline size_t BulkBytesOf(const openr_wire_Message& message) {
  switch (message.payload._d) {
    case openr_wire_PAYLOAD_NOTIFY:
      return BytesIn(message.payload._u.notify.parts);
    case openr_wire_PAYLOAD_READY:
      return BytesIn(message.payload._u.ready.regions);
    default:
      return 0;
  }
}
inline size_t BulkBytesOf(const openr_wire_ToWorker& to_worker) {
  return to_worker.body._d == openr_wire_TO_WORKER_DELIVER
             ? BulkBytesOf(to_worker.body._u.deliver.message)
             : 0;
}
inline size_t BulkBytesOf(const openr_wire_ToMasterBody& body) {
  if (body._d == openr_wire_TO_MASTER_POST) return BulkBytesOf(body._u.post.posted.message);
  return body._d == openr_wire_TO_MASTER_STATE ? BytesIn(body._u.state.regions) : 0;
}
inline size_t BulkBytesOf(const openr_wire_ToMaster& to_master) {
  return std::accumulate(
      to_master.effects._buffer, to_master.effects._buffer + to_master.effects._length,
      BulkBytesOf(to_master.body), [](size_t sum, const openr_wire_Effect& effect) {
        if (effect._d != openr_wire_EFFECT_POST) return sum;
        return sum + BulkBytesOf(effect._u.posted.message);
      });
}

}  // namespace openr_host
