#include "runtime/core/code_place.h"

#include <dlfcn.h>
#include <unwind.h>

#include "runtime/core/current.h"
#include "runtime/core/object.h"

namespace openr_host {
namespace {

PlaceNamer g_namer = nullptr;

struct Search {
  const Object* object;
  const void* found = nullptr;
};

_Unwind_Reason_Code LookAtFrame(_Unwind_Context* context, void* data) {
  Search* const search = static_cast<Search*>(data);
  // The return address is the address of the instruction after the call, which may belong to
  // another source line.  One byte before it is still inside the call.
  const auto* const address = reinterpret_cast<const void*>(_Unwind_GetIP(context) - 1);
  if (!search->object->HasCode(address)) return _URC_NO_REASON;
  search->found = address;
  return _URC_END_OF_STACK;
}

}  // namespace

void SetPlaceNamer(PlaceNamer namer) { g_namer = namer; }

std::string NameOfPlace(const void* address) {
  return g_namer == nullptr || address == nullptr ? "" : g_namer(address);
}

const void* CallerInImage() {
  if (t_current.object == nullptr) return nullptr;
  Search search{t_current.object};
  _Unwind_Backtrace(&LookAtFrame, &search);
  return search.found;
}

std::string AtCaller() {
  if (g_namer == nullptr) return "";
  const std::string place = NameOfPlace(CallerInImage());
  return place.empty() ? "" : ", at " + place;
}

}  // namespace openr_host
