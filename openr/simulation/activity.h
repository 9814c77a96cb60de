// IsActivity(), which tells whether a message is a sign that the objects of a stick still do
// something.
#pragma once

namespace openr_host {

class System;
struct Message;

// Returns whether `message` shows that an object of the stick does something: an object of the
// stick has sent it.  A ready message to a system object does not count.  With such a message an
// object asks the robot for the next sensor values, and programs do so for ever, even when they
// have nothing else to do.
bool IsActivity(const System& system, const Message& message);

}  // namespace openr_host
