// antSharedBuffer: shared memory through which a program and the network stack pass data.  A
// program must map a buffer before it sends data that lie in the buffer.
#include <antSharedBuffer.h>

#include "runtime/core/system.h"
#include "runtime/ipstack/ip_stack.h"

using openr_host::ApiScope;
using openr_host::IpStack;

namespace {

// Tells the master process of a distributed run that this object has mapped or unmapped `buffer`,
// because the network stack runs in the master process (SystemCalls::NoteMapping()).
void NoteMapping(const antSharedBuffer& buffer, bool mapped) {
  openr_host::t_current.system->calls().NoteMapping(buffer.GetCookie(), buffer.GetRegion(), mapped);
}

}  // namespace

antError antSharedBuffer::Map() {
  const ApiScope scope;
  IpStack* const stack = IpStack::OfCurrent();
  if (stack == nullptr) return ANT_FAIL;
  const antError error = stack->buffers().Map(*this, &base_);
  if (error == ANT_SUCCESS) NoteMapping(*this, true);
  return error;
}

antError antSharedBuffer::UnMap() {
  const ApiScope scope;
  IpStack* const stack = IpStack::OfCurrent();
  base_ = nullptr;
  if (stack == nullptr) return ANT_FAIL;
  const antError error = stack->buffers().UnMap(*this);
  if (error == ANT_SUCCESS) NoteMapping(*this, false);
  return error;
}

void* antSharedBuffer::GetAddress() { return base_; }
