#include "openr/ending/crash_stack.h"

#include <dlfcn.h>
#include <strings.h>
#include <ucontext.h>
#include <unwind.h>

#include <cstring>
#include <string>

#include "openr/ending/code_lookup.h"
#include "runtime/core/imported_calls.h"
#include "runtime/core/object.h"
#include "runtime/core/robot_fault.h"

namespace openr_host {
namespace {

const char* LastPart(const char* path) {
  const char* const slash = std::strrchr(path, '/');
  return slash == nullptr ? path : slash + 1;
}

struct StackWalk {
  uintptr_t* addresses;
  size_t max;
  size_t count = 0;
  bool is_outside = false;  // true: the walk has passed the stack frames of the signal handler
};

_Unwind_Reason_Code StoreFrame(_Unwind_Context* context, void* data) {
  StackWalk* const walk = static_cast<StackWalk*>(data);
  int is_interrupted = 0;
  const uintptr_t address = _Unwind_GetIPInfo(context, &is_interrupted);
  walk->is_outside = walk->is_outside || is_interrupted != 0;
  if (!walk->is_outside || IsStackChange(address)) return _URC_NO_REASON;
  if (walk->count == walk->max) return _URC_END_OF_STACK;
  // Stores the address before the return address, because the return address may already belong to
  // the next line or function.  The address before it is inside the call instruction.
  walk->addresses[walk->count++] = is_interrupted != 0 ? address : address - 1;
  return _URC_NO_REASON;
}

// Finds the caller when the process crashed because it called an address without code, such as a
// null pointer to a function.  The unwinder cannot find the caller then, but the return address is
// on top of the stack.  Returns an address inside of the call instruction.
uintptr_t CallerOfNullCall([[maybe_unused]] const void* context) {
#if defined(__x86_64__)
  const auto* const machine = &static_cast<const ucontext_t*>(context)->uc_mcontext;
  return *reinterpret_cast<const uintptr_t*>(machine->gregs[REG_RSP]) - 1;
#else
  return 0;
#endif
}

}  // namespace

CrashStack::CrashStack(const Object& object, const void* context) {
  uintptr_t addresses[kFramesMax];
  StackWalk walk{static_cast<uintptr_t*>(addresses), kFramesMax};
  _Unwind_Backtrace(&StoreFrame, &walk);
  for (size_t i = 0; i < walk.count; ++i) Add(addresses[i], object);
  if (count_ == 1) Add(CallerOfNullCall(context), object);
  size_t last_own = count_;
  while (last_own > 0 && !frames_[last_own - 1].is_own) --last_own;
  if (last_own > 0) count_ = last_own;
  // If the runtime itself has found the fault and announced it, drops the innermost stack frames,
  // so that the first stack frame is of the object's code.  The dropped stack frames belong only to
  // the announcement.
  if (last_own > 0 && AnnouncedFault()[0] != '\0') {
    size_t first_own = 0;
    while (!frames_[first_own].is_own) ++first_own;
    for (size_t i = first_own; i < count_; ++i) frames_[i - first_own] = frames_[i];
    count_ -= first_own;
  }
}

void CrashStack::Add(uintptr_t address, const Object& object) {
  Frame& frame = frames_[count_++];
  frame.address = address;
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(address), &info) == 0 || info.dli_fname == nullptr)
    return;
  frame.file = info.dli_fname;
  frame.offset = address - reinterpret_cast<uintptr_t>(info.dli_fbase);
  frame.is_own = strcasecmp(LastPart(frame.file), LastPart(object.path.c_str())) == 0;
}

void CrashStack::AddFrame(const Frame& frame, SignalText* text) {
  if (frame.file == nullptr) {
    text->Add("no code of a file");
    return;
  }
  text->Add(LastPart(frame.file)).Add("+0x").AddNumber(frame.offset, 16);
  const CodeLookup found = LookUpCode(frame.file, frame.offset);
  if (!found.function.empty()) text->Add(" ").Add(found.function);
  if (!found.line.empty()) text->Add(" (").Add(found.line).Add(")");
}

void CrashStack::AddTo(SignalText* text) const {
  text->Add("STACK\n");
  for (size_t i = 0; i < count_; ++i) {
    text->Add("  #").AddNumber(i).Add(" ");
    AddFrame(frames_[i], text);
    text->Add("\n");
  }
}

const void* CrashStack::OwnAddress() const {
  for (size_t i = 0; i < count_; ++i) {
    if (frames_[i].is_own) return reinterpret_cast<const void*>(frames_[i].address);
  }
  return nullptr;
}

uintptr_t CrashStack::OwnOffset() const {
  for (size_t i = 0; i < count_; ++i) {
    if (frames_[i].is_own) return frames_[i].offset;
  }
  return 0;
}

void CrashStack::AddPlace(SignalText* text) const {
  for (size_t i = 0; i < count_; ++i) {
    if (!frames_[i].is_own) continue;
    text->Add(", at ");
    return AddFrame(frames_[i], text);
  }
}

}  // namespace openr_host
