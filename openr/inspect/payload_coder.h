// Writes the content of messages for a recording.  Writes only words that differ from the last
// message of the same sender and size. docs/trace-format.md describes the layout.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "openr/inspect/byte_stream.h"

namespace openr_host {

// The number of bytes of a message that are compared in one step with the message before.
constexpr size_t kPayloadBlock = 64;

// The payload, that is the content, of the last message of one sender and one size.  Zeros fill it
// up to a multiple of kPayloadBlock.  Before the first message all its bytes are 0.
class LastPayload {
 public:
  explicit LastPayload(size_t size)
      : size_(size), bytes_((size + kPayloadBlock - 1) / kPayloadBlock * kPayloadBlock, '\0') {}

  size_t size() const { return size_; }
  std::string_view bytes() const { return std::string_view(bytes_).substr(0, size_); }

  // Appends to `out` the words of `now` that differ from the last payload.  Then `now` becomes the
  // last payload.  REQUIRES: now.size() == size().
  void Write(std::string_view now, ByteWriter* out);

  // Reads a payload that Write() has written, and makes it the last payload.  Throws
  // std::runtime_error when the read bytes are damaged.
  void Read(ByteReader* in);

  // Reads a payload as Read() does, but in the older form that recordings of format version 4 and
  // earlier have.  This form has pieces of bytes that equal the last payload, and pieces of bytes
  // that differ from it.
  void ReadPieces(ByteReader* in);

 private:
  size_t size_;
  std::string bytes_;
};

}  // namespace openr_host
