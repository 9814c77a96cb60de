// MessagePipe: JSON messages between a run and its copies, over a pair of sockets.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace openr_host {

// A pair of connected sockets.  The constructor makes them, and throws std::system_error if that
// fails.
struct SocketPair {
  SocketPair();
  int first = -1;
  int second = -1;
};

// Sends `message` through `socket`.  The message may have binary values.  Returns false if the
// other end is closed.
bool SendMessage(int socket, const nlohmann::json& message);

// Waits for a message at `socket`, for at most `timeout_ms` (-1: for ever), and returns it.
// Returns nullopt if the other end is closed or no message comes.
std::optional<nlohmann::json> ReceiveMessage(int socket, int timeout_ms);

}  // namespace openr_host
