// An object that writes down what reaches it, and when.
#pragma once

#include <fmt/format.h>

#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "runtime/core/code_object.h"
#include "runtime/core/system.h"
#include "tests/runtime/core/probe.h"

namespace openr_host {

using Log = std::vector<std::string>;

// Entries that write their name and the time into a common log.
class Recorder : public CodeObject {
 public:
  explicit Recorder(Log* log) {
    entry = AddExtra("Entry", [this, log](void* message) {
      log->push_back(
          fmt::format("{}:{}@{}", host().name, *static_cast<int*>(message), system().now_us()));
      if (on_message) on_message(*static_cast<int*>(message));
    });
  }
  Selector entry;
  std::function<void(int)> on_message;
};

// A message with one number for the recorder's entry.
inline int32_t PostTo(Recorder* target, int value, int64_t delay_us = 0,
                      MessageClass message_class = MessageClass::kObject) {
  System& system = target->system();
  OwnedMessage message = system.NewMessage(target->host().id, target->entry);
  std::memcpy(message->payload, &value, sizeof value);
  message->size = sizeof value;
  message->message_class = message_class;
  return system.Post(std::move(message), delay_us);
}

}  // namespace openr_host
