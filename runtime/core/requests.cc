#include "runtime/core/requests.h"

#include <fmt/format.h>
#include <sError.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/dispatcher.h"
#include "runtime/core/system.h"

namespace openr_host {

uint64_t Requests::OpenBox() {
  ASSERT(t_current.object != nullptr, "only an object waits for a reply");
  Object* const self = t_current.object;
  system_->calls().OpenBox(self->boxes().last() + 1);
  return self->boxes().last();
}

int32_t Requests::Send(OwnedMessage message, uint64_t* box) {
  *box = OpenBox();
  message->reply_box = *box;
  const int32_t error = system_->Post(std::move(message));
  if (error != sSUCCESS) t_current.object->boxes().Close(*box);
  return error;
}

OwnedMessage Requests::Await(uint64_t box, int64_t timeout_us, std::string_view why,
                             bool* timed_out) {
  Object* const self = t_current.object;
  ASSERT(self != nullptr && box != 0, "only an object waits, and for a box");
  self->wait().set_why(why);
  const Message* const wake = system_->calls().BeginWait(box, timeout_us, why);
  OwnedMessage message = system_->dispatcher().WaitFor(box);
  self->wait().set_why("");
  // If the wait for the reply has timed out, `message` is the empty reply that
  // LocalCalls::BeginWait() has posted from the object to itself.
  *timed_out = message->kind == PayloadKind::kHashed && message->sender == self->id;
  if (*timed_out) {
    // The wait has ended without a reply: at the time-out by the message `wake`, or by another
    // message because the request was refused (cpu.h).  In the second case `wake` is still in the
    // queue, so removes it.  The box stays open, because the reply may still come after a time-out.
    if (wake != nullptr && wake != message.get())
      system_->queue().TakeIf([wake](const Message& m) { return &m == wake; });
    return message;
  }
  // The reply came before the time-out.  Removes `wake`, the message that would have ended the
  // wait.
  if (wake != nullptr) system_->queue().TakeIf([wake](const Message& m) { return &m == wake; });
  // Closes the box, because the reply has ended the wait of the handler.  Reply events (messages
  // that the object has ordered for this reply) can never be posted any more.  Removes them,
  // because they would still count among the events of the object.
  if (self->boxes().Close(box)) system_->time_events().ForgetBox(self->id, box);
  return message;
}

int32_t Requests::Wait(uint64_t box, void* reply, size_t reply_size, size_t* got,
                       int64_t timeout_us, std::string_view why) {
  bool timed_out = false;
  const OwnedMessage message = Await(box, timeout_us, why, &timed_out);
  const size_t size = std::min<size_t>(message->size, reply_size);
  if (reply != nullptr) std::memcpy(reply, message->payload, size);
  if (got != nullptr) *got = size;
  return timed_out ? sTIMEOUT : sSUCCESS;
}

int32_t Requests::Call(ObjectId target, uint32_t selector, const void* data, size_t size,
                       void* reply, size_t reply_size, int64_t timeout_us) {
  if (size > Message::kPayloadMax) return sEXCEEDEDSIZEOFMSG;
  OwnedMessage message = system_->NewMessage(target, selector);
  std::memcpy(message->payload, data, size);
  message->size = static_cast<uint32_t>(size);
  uint64_t box = 0;
  const Object* const callee = system_->object(target);
  const int32_t error = Send(std::move(message), &box);
  if (error != sSUCCESS) return error;
  const std::string why =
      fmt::format("the answer of {} ({})", callee->name, callee->EntryName(selector));
  // Waits again after a time-out if the receiver of the request (`target`) itself waits for
  // something that takes wall time (is_untimed).  The time-out is in virtual time, so it does not
  // show then that the receiver takes too long.
  for (;;) {
    const int32_t result = Wait(box, reply, reply_size, nullptr, timeout_us, why);
    // Does not wait again after a wait without a limit (timeout_us < 0), because such a wait ends
    // with sTIMEOUT only if the request was refused (cpu.h).
    const bool may_repeat = timeout_us >= 0 && system_->object(target)->wait().is_untimed();
    if (result != sTIMEOUT || !may_repeat) return result;
  }
}

ReplyTicket Requests::TakeTicket() {
  Message* const request = t_current.object == nullptr ? nullptr : t_current.object->running();
  if (request == nullptr || request->reply_box == 0) return {};
  const ReplyTicket ticket{request->sender, request->reply_box};
  // Marks the right to reply to the request as taken, because each request gets only one reply.
  request->reply_box = 0;
  return ticket;
}

int32_t Requests::Reply(const ReplyTicket& ticket, const void* data, size_t size,
                        uint64_t payload_hash) {
  if (ticket.box == 0) return sINVALIDRID;
  if (size > Message::kPayloadMax) return sEXCEEDEDSIZEOFMSG;
  const Object* const asker = system_->object(ticket.to);
  if (asker == nullptr) return sRBOXWASCLEANED;
  if (!system_->calls().AcceptsReply(asker->id, ticket.box)) return sRBOXWASCLEANED;
  OwnedMessage message = system_->NewMessage(ticket.to, 0);
  message->is_reply = true;
  message->reply_box = ticket.box;
  if (size > 0) std::memcpy(message->payload, data, size);
  message->size = static_cast<uint32_t>(size);
  if (payload_hash != 0) {
    message->kind = PayloadKind::kHashed;
    message->payload_hash = payload_hash;
  }
  return system_->Post(std::move(message));
}

int32_t ReplyToRequest(const void* data, size_t size) {
  Object* const object = t_current.object;
  if (object == nullptr) return sFAIL;
  if (size > kMessageMax) return sEXCEEDEDSIZEOFMSG;
  // If an observer and a subject of the same object are connected, the object calls the entry of
  // its subject directly and sends no request.  The caller has given memory for the reply
  // (self_reply), so copies the reply there.
  if (object->self_reply() != nullptr) {
    std::memcpy(object->self_reply()->data, data, std::min(size, object->self_reply()->size));
    return sSUCCESS;
  }
  Requests& requests = t_current.system->requests();
  return requests.Reply(requests.TakeTicket(), data, size);
}

}  // namespace openr_host
