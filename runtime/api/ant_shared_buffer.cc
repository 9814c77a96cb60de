#include <antSharedBuffer.h>

#include "runtime/core/system.h"
#include "runtime/ipstack/ip_stack.h"

using openr_host::ApiScope;
using openr_host::IpStack;

namespace {

void TellUplink(const antSharedBuffer& buffer, bool mapped) {
  openr_host::Uplink* const uplink = openr_host::t_current.system->uplink();
  if (uplink == nullptr) return;
  uplink->Tell(openr_host::NoteKind::kMapBuffer,
               {buffer.GetCookie(), buffer.GetRegion(), mapped ? uint64_t{1} : uint64_t{0}});
}

}  // namespace

antError antSharedBuffer::Map() {
  const ApiScope scope;
  IpStack* const stack = IpStack::OfCurrent();
  if (stack == nullptr) return ANT_FAIL;
  const antError error = stack->buffers().Map(*this, &base_);
  if (error == ANT_SUCCESS) TellUplink(*this, true);
  return error;
}

antError antSharedBuffer::UnMap() {
  const ApiScope scope;
  IpStack* const stack = IpStack::OfCurrent();
  base_ = nullptr;
  if (stack == nullptr) return ANT_FAIL;
  const antError error = stack->buffers().UnMap(*this);
  if (error == ANT_SUCCESS) TellUplink(*this, false);
  return error;
}

void* antSharedBuffer::GetAddress() { return base_; }
