#include "openr/ending/endless_work.h"

#include <unistd.h>

#include "openr/ending/ending.h"
#include "runtime/core/current.h"
#include "runtime/core/object.h"

namespace openr_host {

uint64_t CurrentWork() {
  constexpr uint64_t kLoading = uint64_t{1} << 63;
  const Object* const object = t_current.object;
  if (object == nullptr) return 0;
  if (object->running() != nullptr) return object->running()->number;
  return object->is_image() ? kLoading | object->id : 0;
}

void EndCurrentWork(EndKind kind, const SignalText& why) {
  Ending ending;
  ending.kind = kind;
  const Object* const object = t_current.object;
  const char* const what = object != nullptr && object->running() == nullptr
                               ? "the loading or unloading of an image does not end: "
                               : "a handler does not return: ";
  ending.record.Add("openr: ").Add(what);
  AddCurrentHandler(&ending.record);
  ending.record.Add("; it").Add(why.text()).Add("\n");
  AddCurrentMessage(&ending.record);
  ending.finding.Add(what);
  AddCurrentEntry(&ending.finding);
  ending.finding.Add(why.text());
  BeginEnding(&ending);
  ending.record.WriteTo(STDERR_FILENO);
  FinishEnding();
}

}  // namespace openr_host
