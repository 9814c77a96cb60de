// Tells whether the objects of a stick do anything.
#pragma once

namespace openr_host {

class System;
struct Message;

// Returns whether an object of the stick sent `message`, except for readiness for the next vector
// of a system object.  Sensor values, and the readiness for them, go on for ever and so are no
// activity.
bool IsActivity(const System& system, const Message& message);

}  // namespace openr_host
