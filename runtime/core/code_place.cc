#include "runtime/core/code_place.h"

#include <dlfcn.h>
#include <unwind.h>

#include <string_view>

#include "runtime/core/current.h"
#include "runtime/core/object.h"

namespace openr_host {
namespace {

PlaceNamer g_namer = nullptr;

struct Search {
  const Object* object;
  const void* found = nullptr;
};

_Unwind_Reason_Code SearchFrame(_Unwind_Context* context, void* data) {
  Search* const search = static_cast<Search*>(data);
  // Subtracts 1, because _Unwind_GetIP() returns the address of the instruction after a call, which
  // may belong to another source line.  The result is an address inside the call.
  const auto* const address = reinterpret_cast<const void*>(_Unwind_GetIP(context) - 1);
  if (!search->object->HasCode(address)) return _URC_NO_REASON;
  search->found = address;
  return _URC_END_OF_STACK;
}

struct CallSearch {
  const char* image;
  std::vector<const void*> found;
};

_Unwind_Reason_Code CollectFrame(_Unwind_Context* context, void* data) {
  CallSearch* const search = static_cast<CallSearch*>(data);
  // Subtracts 1, because _Unwind_GetIP() returns the address of the instruction after a call, which
  // may belong to another source line.  The result is an address inside the call.
  const auto* const address = reinterpret_cast<const char*>(_Unwind_GetIP(context) - 1);
  if (address >= search->image && address < search->image + ObjectAddresses::kImageBytes)
    search->found.push_back(address);
  return search->found.size() < kCallsMax ? _URC_NO_REASON : _URC_END_OF_STACK;
}

bool IsInHeader(std::string_view place) {
  const std::string_view file = place.substr(0, place.rfind(':'));
  return file.find('.') == std::string_view::npos || file.ends_with(".h") ||
         file.ends_with(".hpp") || file.ends_with(".tcc");
}

}  // namespace

std::vector<const void*> CallsInImage() {
  const Object* const object = t_current.object;
  if (object == nullptr || object->memory().addresses() == nullptr ||
      object->memory().addresses()->image() == nullptr)
    return {};
  CallSearch search{object->memory().addresses()->image(), {}};
  _Unwind_Backtrace(&CollectFrame, &search);
  return search.found;
}

std::string NameOfCalls(const std::vector<const void*>& calls) {
  std::string first;
  for (const void* const call : calls) {
    std::string name = NameOfPlace(call);
    if (!name.empty() && !IsInHeader(name)) return name;
    if (first.empty()) first = std::move(name);
  }
  return first;
}

void SetPlaceNamer(PlaceNamer namer) { g_namer = namer; }

std::string NameOfPlace(const void* address) {
  return g_namer == nullptr || address == nullptr ? "" : g_namer(address);
}

const void* CallerInImage() {
  if (t_current.object == nullptr) return nullptr;
  Search search{t_current.object};
  _Unwind_Backtrace(&SearchFrame, &search);
  return search.found;
}

std::string InHandler() {
  const Object* const object = t_current.object;
  if (object == nullptr || object->running() == nullptr) return "";
  return object->EntryName(object->running()->selector) + ": ";
}

std::string AtCaller() {
  if (g_namer == nullptr) return "";
  const std::string place = NameOfPlace(CallerInImage());
  return place.empty() ? "" : ", at " + place;
}

}  // namespace openr_host
