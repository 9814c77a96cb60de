// The interface by which code in a worker reaches the master.  Worker implements it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "distribution/call_codec.h"
#include "runtime/core/message.h"

namespace openr_host {

class MasterLink {
 public:
  virtual ~MasterLink() = default;

  // Posts `message` to its receiver, as SystemCalls::Post() does.
  virtual int32_t Post(OwnedMessage message, int64_t delay_us) = 0;

  // Makes the master call function number `function` of WorkerCallList, the list of the master's
  // functions that workers may call.  Does not wait for the call, so there is no result.
  // `arguments` must have no `bytes`, because the sample that carries them has no member for bytes.
  virtual void Tell(uint32_t function, const CallArguments& arguments) = 0;
  // Makes the master call function number `function` of WorkerCallList (the list of the master's
  // functions that workers may call), waits for the call and returns its result.
  virtual CallResult Ask(uint32_t function, const CallArguments& arguments) = 0;

  // Records that the handler of the current object is about to wait for a reply.  `box` is the
  // number under which the object receives the reply.  If `timeout_us` is less than 0, the wait has
  // no limit.
  virtual void RecordWait(uint64_t box, int64_t timeout_us, std::string_view why) = 0;
  // Records that the handler of the current object is about to wait for a line of the console, of
  // at most `size` bytes.  The line arrives as a reply with the number `box`.
  virtual void RecordWaitForLine(uint64_t box, size_t size) = 0;
};

}  // namespace openr_host
