// EarlyWork: what the constructors of an image do while another object still has the id of the
// image.
//
// A reload loads the new image before the old object ends, so that nothing changes if the image
// cannot be loaded.  Until then both objects have the same id.  So the end of the old object would
// also end what the constructors of the new image have made.  And messages that these constructors
// send to their own object would go to the old object.  Therefore everything that the constructors
// make and send is kept apart until the new object is in place.  The same holds for the objects of
// a restarted worker process (distribution/worker_group_restart.cc).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/time_events.h"

namespace openr_host {

class Object;

// The messages of the constructors are not here, but in the outbox of the new object (cpu.h).
struct EarlyWork {
  std::vector<uint32_t> regions;   // without owner (kNoObject) until they are restored
  TimeEvents::Events events;       // not in TimeEvents until they are restored
  std::vector<std::string> names;  // names that were given to Register() (MCOOP.h)
  std::vector<std::pair<std::string, uint32_t>> services;  // names and selectors
};

// Calls `load`, which runs the constructors of the image `fresh`, and returns what they have done.
// `old` is the object that `fresh` is to replace.
EarlyWork CollectEarlyWork(Object* fresh, Object* old, const std::function<void()>& load);

// Gives `fresh`, which has replaced the old object, what its own constructors have made, and sends
// the messages of these constructors.
void RestoreEarlyWork(Object* fresh);

// Deletes what the constructors of `fresh` have made, because `fresh` will not replace the old
// object.
void DropEarlyWork(Object* fresh);

}  // namespace openr_host
