#include "runtime/core/entry_names.h"

#include <OPENR/OPENR.h>
#include <fmt/format.h>

namespace openr_host {

std::string EntryNames::TextOf(uint32_t selector) const {
  switch (selector) {
    case oentryINIT:
      return "DoInit";
    case oentrySTART:
      return "DoStart";
    case oentrySTOP:
      return "DoStop";
    case oentryDESTROY:
      return "DoDestroy";
    case UNDEF:
      return "(reply)";
    default:
      break;
  }
  if (const std::string* const name = FindName(selector)) return *name;
  if (const std::string* const service = FindService(selector))
    return *service + (service->ends_with(".S") ? " (Control)" : " (Connect)");
  return fmt::format("selector {}", selector);
}

}  // namespace openr_host
