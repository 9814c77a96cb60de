// The generated types of openr_wire.idl, and what makes them bearable in C++.
#pragma once

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "openr_wire.h"

namespace openr_host {

// Keeps what a sample points to until it has been written.
class WireArena {
 public:
  // A sequence of the generated type Seq over `items`.
  template <typename Seq, typename T>
  Seq Sequence(std::vector<T> items) {
    auto kept = std::make_shared<std::vector<T>>(std::move(items));
    const auto count = static_cast<uint32_t>(kept->size());
    Seq sequence{count, count, kept->data(), false};
    kept_.push_back(std::move(kept));
    return sequence;
  }

  char* Text(std::string_view text) {
    static char nothing[] = "";
    if (text.empty()) return nothing;
    auto kept = std::make_shared<std::string>(text.substr(0, text.find('\0')));
    kept_.push_back(kept);
    return kept->data();
  }

  openr_wire_Numbers Numbers(std::vector<uint64_t> numbers) {
    return Sequence<openr_wire_Numbers>(std::move(numbers));
  }

  openr_wire_Bytes Bytes(const void* data, size_t size) {
    const auto* const begin = static_cast<const uint8_t*>(data);
    return Sequence<openr_wire_Bytes>(std::vector<uint8_t>(begin, begin + size));
  }

  // Bytes that stay where they are until the sample has been written.
  static openr_wire_Bytes View(const void* data, size_t size) {
    const auto count = static_cast<uint32_t>(size);
    return {count, count, static_cast<uint8_t*>(const_cast<void*>(data)), false};
  }

  void Clear() { kept_.clear(); }

 private:
  std::vector<std::shared_ptr<void>> kept_;
};

inline std::vector<uint64_t> VectorOf(const openr_wire_Numbers& numbers) {
  return {numbers._buffer, numbers._buffer + numbers._length};
}
inline std::string StringOf(const openr_wire_Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes._buffer), bytes._length};
}
// Of a string member, which may be null.
inline std::string StringOf(const char* text) { return text == nullptr ? "" : text; }

}  // namespace openr_host
