// Converts the content of messages to text that people can read.
#pragma once

#include <string>

#include "openr/live/message_history.h"

namespace openr_host {

struct RobotModel;

// Returns the content of a message as text.  A robot of this model has sent the message, by the
// service `subject` ("RCServer.Mover.MoverCommand.S").  The name of the service names the type of
// the content, here MoverCommand.  Content of an unknown type is shown as text if it is printable,
// else as numbers.
std::string DecodeMessage(const RobotModel& model, const std::string& subject,
                          const MessageHistory::Entry& entry);

}  // namespace openr_host
