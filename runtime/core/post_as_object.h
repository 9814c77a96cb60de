// Posts messages in the name of an object, although no handler of this object has sent them.  Used
// by tests, and by the input `send` of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class System;

// An end of a connection: the object, and the selector of the entry that receives the messages of
// the other end.  Subjects receive readies, observers receive notifications.
struct ServiceEnd {
  ObjectId object = kNoObject;
  uint32_t selector = 0;
};
enum class ServiceSide { kSubject, kObserver };

// Returns whether `name` names the service `service`, which is a full name.  `name` may be this
// full name or its beginning up to a dot, such as "Blinker.Blink" for "Blinker.Blink.int.S".
bool NamesService(std::string_view name, std::string_view service);

// Returns the object and the entry of the service `name` of `robot`.  `side` says whether to search
// for a subject or an observer.  Returns nullopt if there is no such service.
std::optional<ServiceEnd> FindService(const System& system, int robot, std::string_view name,
                                      ServiceSide side);

// Returns the names of all subjects that are connected with `observer`, the name of an observer.
std::vector<std::string> SubjectsOf(const System& system, int robot, std::string_view observer);

// Posts a notification with the data `datum` to `observer`, as if `subject` had sent it.  The
// notification arrives even if the observer is not ready.  Returns "", or the reason why nothing
// was posted: subject and observer are not connected, `datum` is larger than a region can be, or
// the queue is full.
std::string PostNotification(System* system, const ServiceEnd& subject, const ServiceEnd& observer,
                             std::string_view datum);
// Posts a ready, or a deassert if `is_ready` is false, to `subject`, as if `observer` had sent it.
// Returns "", or the reason why nothing was posted: subject and observer are not connected, or the
// queue is full.
std::string PostReady(System* system, const ServiceEnd& observer, const ServiceEnd& subject,
                      bool is_ready);

}  // namespace openr_host
