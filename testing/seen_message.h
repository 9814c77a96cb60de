// A message as a test sees it.  The message may be on its way, refused, or being delivered.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/core/message.h"

namespace openr_host {
class System;
}

namespace openr::testing {

enum class MessageKind : uint8_t {
  kNotify,    // data of a subject for an observer
  kReady,     // AssertReady() of an observer, for a subject
  kNotReady,  // DeassertReady()
  kReply,     // answer to a Call(), or to a Send() that wants one
  kOther,     // DoInit and the like, extra entries, messages of the system
};

// Returns "notify", "ready" and so on; null for kOther, which is named by its entry.
const char* WordFor(MessageKind kind);

class SeenMessage {
 public:
  // `system` must outlive this object.  `message` must live as long as the data are read; see
  // Past().
  SeenMessage(const openr_host::System& system, const openr_host::Message& message);

  // Returns a copy without data, which can be used after the message is gone.
  SeenMessage Past() const;

  uint64_t number() const { return number_; }  // 0: has no number yet, or was refused
  uint64_t cause() const { return cause_; }    // number of the message whose handler sent this one
  int64_t time_us() const { return time_us_; }
  MessageKind kind() const { return kind_; }
  uint32_t size() const { return size_; }  // bytes of content

  // An end of a message: an object and, for messages over a connection, the full name of its
  // service ("Blinker.Blink.int.S").  Texts that are not known are empty.
  struct End {
    std::string_view object;
    std::string_view service;
  };
  End from() const;
  End to() const;
  // Returns the entry: "DoStart", "notify", "Alarm".
  std::string entry() const;

  // Returns the number of data of a notification; 1 for other messages of plain bytes; 0 for
  // Past().
  int data_count() const;
  // Returns the bytes of datum `i`.  REQUIRES: 0 <= i < data_count().
  std::string_view data(int i) const;

  // Returns "#4711 t=1.248000 JointMover.Move -> OVirtualRobotComm.Effector notify, 5120 bytes,
  // caused by #4702".
  std::string Text() const;

 private:
  const openr_host::System* system_;
  const openr_host::Message* message_;
  MessageKind kind_ = MessageKind::kOther;
  uint64_t number_ = 0;
  uint64_t cause_ = 0;
  int64_t time_us_ = 0;
  openr_host::ObjectId sender_ = openr_host::kNoObject;
  uint32_t sender_entry_ = 0;  // entry of the sender's end of a connection
  openr_host::ObjectId target_ = openr_host::kNoObject;
  uint32_t selector_ = 0;
  uint32_t size_ = 0;
};

// Returns "Blinker.Blink" for an end with a service, and the object's name for an end without.
std::string ShortName(const SeenMessage::End& end);

}  // namespace openr::testing
