// MessageFilter: messages that a program waits for, by their kind, ends and entry.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/core/message.h"

namespace openr_host {

class System;
struct RobotModel;
struct TraceRecord;

// A message that was delivered, as programs see it.
struct DeliveredMessage {
  uint64_t number = 0;
  uint64_t cause = 0;
  int64_t time_us = 0;
  std::string kind;  // "notify", "ready", "not ready", "reply" or "other"
  std::string from;  // service, or object without one: "RCServer.Mover.MoverCommand.S"
  std::string to;
  std::string entry;  // name of the receiver's handler
  ObjectId target = kNoObject;
  uint32_t selector = 0;
  std::string content;  // the bytes that a recording has
};

struct MessageFilter {
  // "" fits every message.  An end is named by its object or by the first parts of its service.
  std::string kind, from, to, entry;

  // Returns "" or the reason why no message can ever fit: an unknown kind, object or service.
  std::string Check(const System& system) const;
  bool Fits(const DeliveredMessage& message) const;
  // Returns a text for people: "notify RCServer.Mover -> JointMover.Mover".
  std::string Text() const;
};

// Describes a message that is about to be delivered.
DeliveredMessage Describe(const System& system, const TraceRecord& record, const Message& message);

}  // namespace openr_host
