#include "openr/simulation/activity.h"

#include "runtime/core/system.h"

namespace openr_host {

bool IsActivity(const System& system, const Message& message) {
  const Object* const sender = system.object(message.sender);
  if (sender == nullptr || sender->is_system()) return false;
  const Object* const target = system.object(message.target);
  return message.kind != PayloadKind::kReady || target == nullptr || !target->is_system();
}

}  // namespace openr_host
