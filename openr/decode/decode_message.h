// Converts the content of messages to text that people can read.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/core/message.h"

namespace openr_host {

class System;
struct RobotModel;

// Returns the content of a message as text, with one line for each value.  `model` is the model of
// the robot; it has the names of joints and primitives.  `entry` is the name of a service, or of an
// entry of the receiver, such as "JointMover.Mover.MoverCommand.O (Notify)".  Both names contain
// the type of the content, here MoverCommand.  Messages of the system to an object, such as a power
// status, are recognised by their first word and their size.  Content of an unknown type is shown
// as text if it is printable, else as numbers.  If `content` was cut, the values at its beginning
// are shown.
std::string DecodeContent(const RobotModel& model, const std::string& entry,
                          const std::string& content);

// Returns the text that DecodeContent() makes of the content which the entry `selector` of the
// object `target` has received.  If the robot of the object has no model, joints and primitives are
// shown by their numbers.  Returns "" if `content` is empty, or if the object does not exist any
// more.
std::string DecodeReceived(const System& system, ObjectId target, uint32_t selector,
                           const std::string& content);

// Returns the text that DecodeContent() makes of the content of a message which its receiver has
// begun to handle.  The receiver, or the sender of a notification, may have changed or deleted the
// data meanwhile.  Changed data are shown as they are now; deleted data are not shown.
std::string DecodeHandled(const System& system, const Message& message);

// Default limit for the number of characters that OneLineOf() returns.
constexpr size_t kDecodedLineMax = 120;
// Puts the lines of `text`, which DecodeContent() has returned, on one line with "; " between them.
// If the result has more than `size_max` characters, cuts its end off and puts "..." there.
// REQUIRES: size_max >= 3.
std::string OneLineOf(const std::string& text, size_t size_max = kDecodedLineMax);

// Returns the number and the content of a message for people, such as "message 12: move neck_pan to
// 30.00 deg".  `said` is the content, as DecodeContent() has returned it.  It is shown on one line,
// and its end is cut off if it is long.  If `said` is "", the text is only "message 12".
std::string MessageText(uint64_t number, const std::string& said);

// Returns MessageText() in parentheses after a blank, for the end of a finding's text.  Returns ""
// if `number` is 0, because the finding was then added while no message was handled.
std::string MessageInParentheses(uint64_t number, const std::string& said);

// Returns the data type in the name of a service, such as MoverCommand in
// "RCServer.Mover.MoverCommand.S".
std::string TypeOfService(const std::string& service);

// Number of bytes of a message's content that are kept to decode them later.  A sensor vector of
// any robot has fewer bytes.  The pixels of an image are cut off, because they are not shown.
constexpr size_t kDecodedBytesMax = 16384;

// Returns the content of `message` for DecodeContent() and for recordings.  For a message of the
// network stack, this is a description, such as "IPStack: TCP Listen, port 54000", because the
// bytes of such a message hold memory addresses.  For any other message, it is the result of
// PayloadView() (trace.h).  The result refers to the bytes of the message or to a copy in `*copy`,
// and is valid until the message ends or `*copy` changes.
std::string_view ContentView(const Message& message, std::string* copy);
std::string ContentOf(const Message& message);

}  // namespace openr_host
