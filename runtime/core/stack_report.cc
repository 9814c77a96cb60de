#include "runtime/core/stack_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "runtime/core/current.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

bool IsSurelyTooMuch(const Object& object) {
  return object.statistics().stack_max() > 2 * size_t{object.limits().stack_bytes};
}

std::string Describe(const Object& object) {
  return fmt::format(
      "a handler's own functions used {} bytes of stack, the .ocf file gives {}: on the robot an "
      "overflow damages other memory without a word; give it more there",
      object.statistics().stack_max(), object.limits().stack_bytes);
}

}  // namespace

void NoteStackUse(Object* object, size_t bytes) {
  const ApiScope scope;
  if (bytes <= object->statistics().stack_max()) return;
  const bool was_too_much = IsSurelyTooMuch(*object);
  object->statistics().set_stack_max(bytes);
  System* const system = object->system;
  if (!system->options().strict || object->limits().stack_bytes == 0 || was_too_much ||
      !IsSurelyTooMuch(*object))
    return;
  system->AddFindingAbout(object, Severity::kError,
                          Describe(*object) + " (--strict: the robot stops)");
  system->PowerOff(object->robot, {EndKind::kStrict,
                                   object->name + " used more than twice the stack that its .ocf "
                                                  "file gives"});
}

void ReportStacks(System* system) {
  for (const auto& object : system->objects()) {
    if (object == nullptr || !object->is_image() || object->limits().stack_bytes == 0) continue;
    if (object->statistics().stack_max() <= object->limits().stack_bytes) continue;
    // Adds no warning about this object, because with --strict NoteStackUse() has already added an
    // error about its stack.
    if (system->options().strict && IsSurelyTooMuch(*object)) continue;
    system->AddFindingAbout(object.get(), Severity::kWarning, Describe(*object));
  }
}

}  // namespace openr_host
