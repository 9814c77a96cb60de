// The way from a System that only runs handlers to the one that has everything else.
//
// In a distributed run (distribution/) an object's code, its subjects, observers and the
// memory it uses are in one process; clock, queue, order, trace and robots are in another, the
// master.  The System of the first is given an Uplink.  What a handler does that others can see
// then goes there, in the order in which it is done.  Nothing here knows how.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/core/findings.h"
#include "runtime/core/message.h"

namespace openr_host {

// What the master is told; it does the same with its own tables.
enum class NoteKind : uint32_t {
  kDeleteRegion,  // region
  kPin,           // region
  kUnpin,         // region
  kOwner,         // region, object
  kOpenBox,       // box: the current object may get a reply
  kCloseBox,      // box
  kFinding,       // severity, object + 1 (0: none); text
  kShutdown,      // robot, EndKind; why
  kPowerOff,      // robot, EndKind; why
  kQueueMax,      // messages
  kMapBuffer,     // cookie, region, 1 or 0
  kEntryName,     // selector; what Object::EntryName() says of it
};

// What the master is asked.  Numbers are arguments in the order of the function's; results
// likewise.
enum class QuestionKind : uint32_t {
  kNewRegion,        // bytes, owner -> region
  kResizeRegion,     // region, bytes -> status 1: done
  kRegisterService,  // object, selector; name -> OStatus
  kTimedEvent,       // target, selector, first us, period us; bytes -> event
  kReplyEvent,       // target, selector, box; bytes -> event
  kCancelEvent,      // event -> status 1: done
  kEventCount,       // -> count
  kRegisterName,     // object; name -> sError
  kFindName,         // name -> sError, object
  kUnregisterName,   // name -> sError
  kCheckShare,       // ShareCall, region, protection, other, giving -> sError
  kWriteFile,        // name: the object is about to change a file of the stick
  kService,          // RobotCall and its arguments (distribution/remote_services.cc)
};

struct Question {
  QuestionKind kind{};
  std::vector<uint64_t> numbers = {};
  std::string text = {};
  std::string bytes = {};
};

struct Answer {
  int64_t status = 0;
  std::vector<uint64_t> numbers = {};
  std::string bytes = {};

  uint64_t number(size_t i) const { return i < numbers.size() ? numbers[i] : 0; }
};

class Uplink {
 public:
  virtual ~Uplink() = default;

  // Has System::Post()'s meaning and result.  Takes `message`, which is of this System's pool.
  virtual int32_t Post(Message* message, int64_t delay_us) = 0;

  virtual void Tell(NoteKind kind, std::vector<uint64_t> numbers, std::string_view text) = 0;
  void Tell(NoteKind kind, std::vector<uint64_t> numbers) { Tell(kind, std::move(numbers), {}); }

  // The answer is there when this returns.
  virtual Answer Ask(const Question& question) = 0;

  // The current object is about to wait for the reply to `box`; timeout_us < 0: for ever.
  virtual void Waits(uint64_t box, int64_t timeout_us, std::string_view why) = 0;
  // The same, for a line of the console, of at most `size` bytes, which comes as the reply.
  virtual void WaitsForLine(uint64_t box, size_t size) = 0;
};

}  // namespace openr_host
