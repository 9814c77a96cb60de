// MessageFilter: a condition on messages, by kind, sender, receiver and entry.  A program that
// controls a run through the Python module waits for a message that meets the condition.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/core/message.h"

namespace openr_host {

class System;
struct RobotModel;
struct TraceRecord;

// A delivered message, in the form in which the program that drives the run gets it.
struct DeliveredMessage {
  uint64_t number = 0;
  uint64_t cause = 0;
  int64_t time_us = 0;
  std::string kind;  // kind of the message: "notify", "ready", "not ready", "reply" or "other"
  // The service of the message's sender, "RCServer.Mover.MoverCommand.S", or else the name of the
  // sender's object.
  std::string from;
  // The receiver of the message, in the same form as the sender in `from`.
  std::string to;
  std::string entry;  // name of the receiver's handler for the message
  ObjectId target = kNoObject;
  uint32_t selector = 0;
  std::string content;  // content of the message, as in a recording
};

struct MessageFilter {
  // The conditions of the filter; an empty field is no condition.  A message fits the filter if it
  // meets all conditions.  `from` and `to` each name an object ("RCServer") or a service.  The last
  // parts of the name of a service may be left out ("RCServer.Mover").
  std::string kind, from, to, entry;

  // Checks the filter.  Returns "", or the reason why no message can ever fit: an unknown kind,
  // object or service.
  std::string Check(const System& system) const;
  bool Fits(const DeliveredMessage& message) const;
  // Returns the filter as a text for a human reader, such as "notify RCServer.Mover ->
  // JointMover.Mover".
  std::string Text() const;
};

// Returns the description of a message that is about to be delivered, in the form in which the
// program that drives the run gets it.
DeliveredMessage Describe(const System& system, const TraceRecord& record, const Message& message);

}  // namespace openr_host
