// The functions of antEnvMsg, the base class of all messages to the network stack (IPStack).  They
// send a message, wait for its answer, or answer it.
#include <antEnvMsg.h>
#include <fmt/format.h>

#include <cstring>
#include <utility>

#include "runtime/core/api.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ant_message.h"
#include "runtime/ipstack/ip_stack.h"

using namespace openr_host;

namespace {

// Returns the network stack that `target` names.  Returns null if the robot has no such stack, or
// if no handler of an object runs.  First sets the error field of `message` to "failed", because a
// program may read this field even if Send() or Call() fails.
IpStack* StackFor(const antStackRef& target, antEnvMsg* message) {
  SetAntError(message, ANT_FAIL);  // ANT_FAIL fits every message: 1 means "failed" in all protocols
  IpStack* const stack = IpStack::OfCurrent();
  return stack != nullptr && target.get_oid() == OidOf(stack->host().id) ? stack : nullptr;
}

// Makes the message that carries a copy of `message` to the object of the network stack `stack`.
OwnedMessage NewRequest(IpStack* stack, const antEnvMsg& message) {
  const size_t size = AntMessageSize(message);
  OwnedMessage request =
      t_current.system->NewMessage(stack->host().id, stack->EntryFor(message.dstSelector));
  std::memset(request->payload, 0, sizeof request->payload);
  std::memcpy(request->payload, static_cast<const void*>(&message), size);
  request->size = static_cast<uint32_t>(size);
  request->kind = PayloadKind::kHashed;
  // The trace gets a hash of this message and not its bytes, because the bytes contain memory
  // addresses, which differ from run to run.  If the data to send lie in a mapped shared buffer,
  // the hash covers them too.  Data outside of such a buffer are not read, because their address
  // may be invalid.
  const AntData data = DataToSend(message);
  const bool known = stack->buffers().Contains(data.begin, data.size);
  request->payload_hash = AntMessageHash(message, known ? data.begin : nullptr,
                                         known ? static_cast<size_t>(data.size) : 0);
  return request;
}

antError AntErrorOf(sError error) {
  switch (error) {
    case sSUCCESS:
      return ANT_SUCCESS;
    case sFULLMSGQENTRY:
      return ANT_QUEUE_REJECTED;
    default:
      return ANT_FAIL;
  }
}

}  // namespace

antError antEnvMsg::Send(antStackRef target, OID& oid, int32 entry, int size) {
  const ApiScope scope;
  IpStack* const stack = StackFor(target, this);
  if (stack == nullptr || dstSelector > Entry_antEnv_External) return ANT_FAIL;
  sender = OidOf(t_current.object->id);
  msgSize = size;
  invocationType = ANTENVMSG_SEND;
  // Stores in the message where the answer shall go: to entry `entry` of object `oid`.  The network
  // stack sends its answer later, as a new message to this entry.
  contInfo.oid = oid;
  contInfo.selector = static_cast<Selector>(entry);
  return AntErrorOf(t_current.system->Post(NewRequest(stack, *this)));
}

antError antEnvMsg::Call(antStackRef target, int size) {
  const ApiScope scope;
  IpStack* const stack = StackFor(target, this);
  if (stack == nullptr || dstSelector > Entry_antEnv_External) return ANT_FAIL;
  if (t_current.object->running() == nullptr) {
    t_current.system->AddFinding(
        Severity::kError, fmt::format("Call() of a {} message in a constructor fails: only a "
                                      "handler can wait for an answer; do it in DoInit",
                                      AntMessageName(*this)));
    return ANT_FAIL;
  }
  sender = OidOf(t_current.object->id);
  msgSize = size;
  invocationType = ANTENVMSG_CALL;
  const size_t reply_size = AntMessageSize(*this);
  uint64_t box = 0;
  const sError error = t_current.system->requests().Send(NewRequest(stack, *this), &box);
  if (error != sSUCCESS) return AntErrorOf(error);
  const std::string why = fmt::format("the answer of IPStack ({})", AntMessageName(*this));
  return AntErrorOf(t_current.system->requests().Wait(box, static_cast<void*>(this), reply_size,
                                                      nullptr, -1, why));
}

antEnvMsg* antEnvMsg::Receive(ANTENVMSG msg) { return static_cast<antEnvMsg*>(msg); }

// Answers the request that the running handler has received.  Only a program that is itself a
// network stack calls this function.  The runtime's network stack calls IpStack::Answer(), because
// it often answers when network data arrive, and the handler of the request has ended by then.
antError antEnvMsg::Reply() {
  const ApiScope scope;
  if (t_current.object == nullptr) return ANT_FAIL;
  System& system = *t_current.system;
  const size_t size = AntMessageSize(*this);
  const uint64_t hash = AntMessageHash(*this);
  if (invocationType == ANTENVMSG_CALL) {
    return AntErrorOf(system.requests().Reply(system.requests().TakeTicket(),
                                              static_cast<const void*>(this), size, hash));
  }
  OwnedMessage answer = system.NewMessage(ObjectIdOf(contInfo.oid), contInfo.selector);
  std::memcpy(answer->payload, static_cast<const void*>(this), size);
  answer->size = static_cast<uint32_t>(size);
  answer->kind = PayloadKind::kHashed;
  answer->payload_hash = hash;
  return AntErrorOf(system.Post(std::move(answer)));
}
