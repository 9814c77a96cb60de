#include "openr/rewind/input_log.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

using PlainJson = nlohmann::json;

PlainJson Binary(const std::string& bytes) {
  return PlainJson::binary({bytes.begin(), bytes.end()});
}

std::string TextOf(const PlainJson& binary) {
  const auto& bytes = binary.get_binary();
  return {bytes.begin(), bytes.end()};
}

PlainJson EventJson(const NetworkEvent& event) {
  return {static_cast<int>(event.kind),
          event.handle,
          static_cast<int>(event.error),
          event.remote.ip,
          event.remote.port,
          event.count,
          Binary(event.bytes),
          event.host.name,
          event.host.aliases,
          event.host.addresses};
}

NetworkEvent EventOf(const PlainJson& json) {
  NetworkEvent event;
  event.kind = static_cast<NetworkEvent::Kind>(json.at(0).get<int>());
  event.handle = json.at(1);
  event.error = static_cast<NetError>(json.at(2).get<int>());
  event.remote.ip = json.at(3);
  event.remote.port = json.at(4);
  event.count = json.at(5);
  event.bytes = TextOf(json.at(6));
  event.host.name = json.at(7);
  json.at(8).get_to(event.host.aliases);
  json.at(9).get_to(event.host.addresses);
  return event;
}

}  // namespace

size_t InputLog::BytesOf(const LoggedInput& input) {
  size_t bytes = sizeof input + input.line.size();
  for (const NetworkEvent& event : input.events) bytes += sizeof event + event.bytes.size();
  return bytes;
}

void InputLog::Add(LoggedInput input) {
  if (is_disabled_) return;
  bytes_ += BytesOf(input);
  inputs_.push_back(std::move(input));
}

void InputLog::Disable() {
  DropBefore(end());
  is_disabled_ = true;
}

std::vector<LoggedInput> InputLog::From(uint64_t begin) const {
  ASSERT(begin >= first_ && begin <= end());
  return {inputs_.begin() + static_cast<ptrdiff_t>(begin - first_), inputs_.end()};
}

void InputLog::DropBefore(uint64_t begin) {
  for (; first_ < begin && !inputs_.empty(); ++first_) {
    bytes_ -= BytesOf(inputs_.front());
    inputs_.pop_front();
  }
}

PlainJson ToJson(const std::vector<LoggedInput>& inputs) {
  PlainJson json = PlainJson::array();
  for (const LoggedInput& input : inputs) {
    PlainJson events = PlainJson::array();
    for (const NetworkEvent& event : input.events) events.push_back(EventJson(event));
    json.push_back({input.robot, Binary(input.line), input.time_us, input.messages, input.poll,
                    std::move(events)});
  }
  return json;
}

std::vector<LoggedInput> LoggedInputsOf(const PlainJson& json) {
  std::vector<LoggedInput> inputs;
  for (const PlainJson& each : json) {
    LoggedInput input;
    input.robot = each.at(0);
    input.line = TextOf(each.at(1));
    input.time_us = each.at(2);
    input.messages = each.at(3);
    input.poll = each.at(4);
    for (const PlainJson& event : each.at(5)) input.events.push_back(EventOf(event));
    inputs.push_back(std::move(input));
  }
  return inputs;
}

}  // namespace openr_host
