// The functions of RemoteClient that do not wait for the robot.
#include <fmt/format.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "openr/remote/remote_client.h"

namespace openr_host {

uint16_t RemoteClient::Post(int command, const std::vector<uint8_t>& payload) {
  return SendRequest(command, payload);
}

uint16_t RemoteClient::PostBatch(const std::vector<RemoteCall>& calls) {
  UseVersion(RC_VERSION_FILES);
  return SendRequest(rcBATCH, BatchPayload(calls));
}

// Reads bytes that have arrived until there is a whole packet.  Returns false if there is none.
bool RemoteClient::ReceiveNow() {
  for (;;) {
    const RcFramer::Result result = framer_.Next();
    if (result == RcFramer::PACKET) return true;
    if (result == RcFramer::BROKEN)
      Throw(fmt::format("this is no remote control: {}", framer_.Error()));
    uint8_t bytes[RC_MAX_PACKET];
    const ssize_t n = recv(socket_, bytes, sizeof bytes, MSG_DONTWAIT);
    if (n > 0) {
      framer_.Take(bytes, static_cast<int>(n));
    } else if (n == 0) {
      Throw("the connection was closed by the robot");
    } else if (errno == EAGAIN) {
      return false;
    } else if (errno != EINTR) {
      Throw(fmt::format("the connection was lost ({})", std::strerror(errno)));
    }
  }
}

std::optional<RemotePacket> RemoteClient::TakePacket() {
  RemotePacket packet;
  if (events_.empty()) {
    if (!ReceiveNow()) return std::nullopt;
    RcAnswerHeader header;
    if (!header.Read(framer_)) ThrowMalformed();
    if (!KeepEvent(header)) {
      packet.tag = header.header.tag;
      packet.reply = ReadReply(header, framer_);
      return packet;
    }
  }
  packet.is_event = true;
  packet.event = std::move(events_.front());
  packet.tag = packet.event.tag;
  events_.pop_front();
  return packet;
}

}  // namespace openr_host
