// InputLog: the inputs that came into a run from outside.  The inputs are kept so that a copy of
// the run can repeat them.
#pragma once

#include <cstdint>
#include <deque>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "runtime/ipstack/network.h"

namespace openr_host {

// An input to a run: an input line, or the events that the network of a robot returned.
struct LoggedInput {
  int robot = 0;
  // The input line, such as "press chin"; "" if this input is not a line.
  std::string line;
  // The virtual time when the run got the input line.
  int64_t time_us = 0;
  // The number of messages that the run had delivered when it got the input line.
  uint64_t messages = 0;
  // The number of the call of Network::Poll() that returned `events`. 0: this input is a line.
  uint64_t poll = 0;
  std::vector<NetworkEvent> events;
};

class InputLog {
 public:
  // The largest number of bytes that the inputs in an InputLog may have together; see is_full().
  static constexpr size_t kBytesMax = size_t{64} << 20;

  // Adds an input.  Does nothing after Disable().
  void Add(LoggedInput input);
  // Drops all inputs, and keeps none from now on.
  void Disable();

  // Returns the number of inputs that were added to this InputLog so far.
  uint64_t end() const { return first_ + inputs_.size(); }
  // Returns the inputs from the number `begin` on.  REQUIRES: these inputs were not dropped.
  std::vector<LoggedInput> From(uint64_t begin) const;
  // Drops the inputs whose numbers are below `begin`.
  void DropBefore(uint64_t begin);

  // Returns whether the inputs in this InputLog have together more than kBytesMax bytes.
  bool is_full() const { return bytes_ > kBytesMax; }

 private:
  static size_t BytesOf(const LoggedInput& input);

  std::deque<LoggedInput> inputs_;
  uint64_t first_ = 0;  // number of the oldest input in the log, inputs_.front()
  size_t bytes_ = 0;
  bool is_disabled_ = false;
};

// Converts inputs to JSON with binary values, to send them to another process.
nlohmann::json ToJson(const std::vector<LoggedInput>& inputs);
// Returns the inputs from which ToJson() has made `json`.
std::vector<LoggedInput> LoggedInputsOf(const nlohmann::json& json);

}  // namespace openr_host
