#include <antSharedBuffer.h>

#include "runtime/core/current.h"
#include "runtime/ipstack/ip_stack.h"

using openr_host::ApiScope;
using openr_host::IpStack;

antError antSharedBuffer::Map() {
  const ApiScope scope;
  IpStack* const stack = IpStack::OfCurrent();
  return stack == nullptr ? ANT_FAIL : stack->buffers().Map(*this, &base_);
}

antError antSharedBuffer::UnMap() {
  const ApiScope scope;
  IpStack* const stack = IpStack::OfCurrent();
  base_ = nullptr;
  return stack == nullptr ? ANT_FAIL : stack->buffers().UnMap(*this);
}

void* antSharedBuffer::GetAddress() { return base_; }
