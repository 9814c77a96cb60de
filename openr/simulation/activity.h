// Whether the objects of a stick do anything.
#pragma once

namespace openr_host {

class System;
struct Message;

// Whether an object of the stick sent `message`, but for its readiness for the next vector of a
// system object: sensor values and asking for more of them go on for ever.
bool IsActivity(const System& system, const Message& message);

}  // namespace openr_host
