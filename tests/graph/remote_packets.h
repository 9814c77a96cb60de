// Packets of the remote control for tests of the whole graph: requests to send, answers heard.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "RemoteProtocol.h"

namespace openr_host {

// Returns the bytes of a request of version 2.
inline std::string RcPacket(int command, const std::string& payload = "", int tag = 1,
                            int version = RC_VERSION_FILES) {
  uint8_t bytes[RC_MAX_PACKET];
  RcWriter out(bytes, RC_MAX_PACKET);
  for (int i = 0; i < RC_HEADER_SIZE; ++i) out.U8(0);
  out.Bytes(reinterpret_cast<const Uint8*>(payload.data()), static_cast<int>(payload.size()));
  out.PutHeader(command, tag, version);
  return {reinterpret_cast<char*>(bytes), static_cast<size_t>(out.Size())};
}

// Returns the bytes of `payload`, a struct of RemoteProtocol.h.
template <typename Payload>
std::string RcBytes(const Payload& payload) {
  uint8_t bytes[RC_MAX_PACKET];
  RcWriter out(bytes, RC_MAX_PACKET);
  payload.Write(&out);
  return {reinterpret_cast<char*>(bytes), static_cast<size_t>(out.Size())};
}

// Returns one byte, then `value` as four, as for MOVE.
inline std::string RcIndexAndValue(int index, int32_t value) {
  std::string bytes(1, static_cast<char>(index));
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift);
  return bytes;
}

// A packet that the robot has sent.
struct HeardPacket {
  int command = 0, tag = 0, status = 0;
  uint32_t frame = 0;
  std::string payload;

  template <typename Payload>
  Payload Read() const {
    Payload message{};
    RcReader in(reinterpret_cast<const Uint8*>(payload.data()), static_cast<int>(payload.size()));
    EXPECT_TRUE(message.Read(&in));
    return message;
  }
};

// Returns all whole packets in `heard`.
inline std::vector<HeardPacket> RcHeard(const std::string& heard) {
  std::vector<HeardPacket> packets;
  for (size_t at = 0; at + RC_ANSWER_HEADER_SIZE <= heard.size();) {
    RcFramer framer;
    const size_t count = std::min<size_t>(heard.size() - at, RC_MAX_PACKET);
    framer.Append(reinterpret_cast<const Uint8*>(heard.data()) + at, static_cast<int>(count));
    RcAnswerHeader header;
    if (framer.Next() != RcFramer::PACKET || !header.Read(framer)) break;
    const size_t begin = at + RC_ANSWER_HEADER_SIZE;
    packets.push_back({header.header.command, header.header.tag, header.status, header.frame,
                       heard.substr(begin, header.header.size - RC_ANSWER_HEADER_SIZE)});
    at += header.header.size;
  }
  return packets;
}

}  // namespace openr_host
