// Makes bytes of the gateway's protocol for tests, without the code under test.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace openr_host {

inline std::string Words(std::initializer_list<uint32_t> words) {
  std::string bytes;
  for (const uint32_t word : words)
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift);
  return bytes;
}

// Returns a set of one item.
inline std::string OneItem(const std::string& text) {
  const auto size = static_cast<uint32_t>(text.size());
  return Words({8 + size, 1, size}) + text;
}

// Returns `text` with zeros behind it, in all `size` bytes.
inline std::string Padded(std::string text, size_t size) {
  text.resize(size, '\0');
  return text;
}

inline const std::string kReadyWord = Words({3});
inline const std::string kNotReadyWord = Words({4});

}  // namespace openr_host
