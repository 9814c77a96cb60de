// LiveClient, through which openr poke and openr attach send requests to the socket of a run
// (live_server.h).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "openr/live/live_folder.h"

namespace openr_host {

class LiveClient {
 public:
  static constexpr int kTimeoutMs = 10'000;

  // Connects to the run.  Throws std::runtime_error if the run cannot be reached within
  // `timeout_ms`.
  explicit LiveClient(const LiveRun& run, int timeout_ms = kTimeoutMs);
  ~LiveClient();
  LiveClient(const LiveClient&) = delete;
  LiveClient& operator=(const LiveClient&) = delete;

  // Sends `request` and returns the answer.  Throws std::runtime_error if the run ends before its
  // answer, or does not answer within `timeout_ms`.
  nlohmann::ordered_json Ask(const nlohmann::ordered_json& request);

 private:
  const std::string name_;
  const int timeout_ms_;
  int descriptor_ = -1;
  std::string received_;
};

}  // namespace openr_host
