// Writes the bytes of messages for a recording: only words that differ from the last bytes of the
// same sender and size.  docs/trace-format.md describes the layout.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "openr/inspect/byte_stream.h"

namespace openr_host {

// The number of bytes that are compared together.
constexpr size_t kPayloadBlock = 64;

// The last payload of a sender and a size, followed by zeros up to a multiple of kPayloadBlock.
// Begins as zeros.
class LastPayload {
 public:
  explicit LastPayload(size_t size)
      : size_(size), bytes_((size + kPayloadBlock - 1) / kPayloadBlock * kPayloadBlock, '\0') {}

  size_t size() const { return size_; }
  std::string_view bytes() const { return std::string_view(bytes_).substr(0, size_); }

  // Appends the words of `now` that differ from the last payload, which `now` becomes.  REQUIRES:
  // now.size() == size().
  void Write(std::string_view now, ByteWriter* out);

  // Reads what Write() has written and makes it the last payload.  Throws std::runtime_error when
  // the bytes are damaged.
  void Read(ByteReader* in);

  // Reads the pieces of bytes that programs before version 5 of the format have written.
  void ReadPieces(ByteReader* in);

 private:
  size_t size_;
  std::string bytes_;
};

}  // namespace openr_host
