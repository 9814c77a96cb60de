// IsActivity(), which tells whether the objects of a stick still do something.
#pragma once

namespace openr_host {

class System;
struct Message;

// Returns whether `message` shows that an object of the stick does something: the object has sent
// it.  A ready to a system object does not count, because objects ask for sensor values for ever.
bool IsActivity(const System& system, const Message& message);

}  // namespace openr_host
