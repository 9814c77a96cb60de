// Writes the content of messages as text, for people who look at a run.
#pragma once

#include <string>

#include "openr/live/message_history.h"

namespace openr_host {

struct RobotModel;

// Returns the content of a message of the service `subject` ("RCServer.Mover.MoverCommand.S"),
// which a robot of this model has sent.  The type of the content, here MoverCommand, is taken from
// the name of the service.  Content of types that are not known here is shown as text if it is
// printable, else as numbers.
std::string DecodeMessage(const RobotModel& model, const std::string& subject,
                          const MessageHistory::Entry& entry);

}  // namespace openr_host
