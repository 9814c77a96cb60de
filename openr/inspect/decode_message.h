// Converts the content of messages to text that people can read.
#pragma once

#include <string>

namespace openr_host {

struct RobotModel;

// Returns the content of a message as text, a line for each value.  `model` is the model of the
// robot on which the message was sent.  `entry` is the name of a service or of the receiver's entry
// ("RCServer.Mover.MoverCommand.S (Ready)").  It contains the type of the content, here
// MoverCommand.  Content of an unknown type is shown as text if it is printable, else as numbers.
std::string DecodeContent(const RobotModel& model, const std::string& entry,
                          const std::string& content);

}  // namespace openr_host
