// Converts the content of messages to text that people can read.
#pragma once

#include <string>
#include <string_view>

#include "runtime/core/message.h"

namespace openr_host {

class System;
struct RobotModel;

// Returns the content of a message as text, a line for each value.  A robot of this model has sent
// it.  `entry` is the name of a service or of the receiver's entry ("RCServer.Mover.MoverCommand.S
// (Ready)").  The name of the service names the type of the content, here MoverCommand.  Messages
// of the system to an object, such as a power status, are recognised by their first word and their
// size.  Content of an unknown type is shown as text if it is printable, else as numbers.
// `content` may have been cut; then the values of its beginning are shown.
std::string DecodeContent(const RobotModel& model, const std::string& entry,
                          const std::string& content);

// The same for content that entry `selector` of object `target` has received.  If the robot of the
// object has no model, joints and primitives are shown by their numbers.  Returns "" if `content`
// is empty, or if there is no such object any more.
std::string DecodeReceived(const System& system, ObjectId target, uint32_t selector,
                           const std::string& content);

// The same for a message that its receiver has begun to handle.  The receiver, or the sender of a
// notification, may have changed or deleted the data meanwhile: they are shown as they are now, and
// not at all if they are deleted.
std::string DecodeHandled(const System& system, const Message& message);

// Returns a text of DecodeContent() on one line: "; " is between its lines, and a text of more than
// `size_max` characters is cut and ends with "...".  REQUIRES: size_max >= 3.
constexpr size_t kDecodedLineMax = 120;
std::string OneLineOf(const std::string& text, size_t size_max = kDecodedLineMax);

// Returns the data type in the name of a service: MoverCommand of "RCServer.Mover.MoverCommand.S".
std::string TypeOfService(const std::string& service);

// Number of bytes of content to keep for decoding it later.  A sensor vector of any robot fits, and
// the pixels of an image, which are not shown, are cut off.
constexpr size_t kDecodedBytesMax = 16384;

// Returns the content of `message` for DecodeContent() and for recordings, without a copy where the
// bytes are in one piece, otherwise in `*copy`.  It is that of PayloadView() (trace.h), except that
// a message of the network stack, whose bytes hold memory addresses, has its description as
// content: "IPStack: TCP Listen, port 54000".  The result is valid until the message ends or
// `*copy` changes.
std::string_view ContentView(const Message& message, std::string* copy);
std::string ContentOf(const Message& message);

}  // namespace openr_host
