// A message as a test sees it: on its way, refused, or being delivered.
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
  kReady,     // of an observer for a subject: AssertReady()
  kNotReady,  // DeassertReady()
  kReply,     // answers a Call() or Send() with an answer
  kOther,     // DoInit and its kin, extra entries, messages of the system
};

// "notify", "ready" and so on; null for kOther, which goes by its entry.
const char* WordFor(MessageKind kind);

class SeenMessage {
 public:
  // `system` must outlive this; `message` may go, see Past().
  SeenMessage(const openr_host::System& system, const openr_host::Message& message);

  // What is left of it when it is over: everything but its data.
  SeenMessage Past() const;

  uint64_t number() const { return number_; }  // 0: not numbered yet, or refused
  uint64_t cause() const { return cause_; }    // number of the message whose handler sent it
  int64_t time_us() const { return time_us_; }
  MessageKind kind() const { return kind_; }
  uint32_t size() const { return size_; }  // bytes of content

  // One end: an object and, for what goes over a connection, its service by full name
  // ("Blinker.Blink.int.S").  Empty texts: not known.
  struct End {
    std::string_view object;
    std::string_view service;
  };
  End from() const;
  End to() const;
  // "DoStart", "notify", "Alarm".
  std::string entry() const;

  // What a notification carries, datum by datum; other messages that are plain bytes
  // have one.  0 when it is over.
  int data_count() const;
  // REQUIRES: 0 <= i < data_count().
  std::string_view data(int i) const;

  // "#4711 t=1.248000 JointMover.Move -> OVirtualRobotComm.Effector notify, 5120 bytes,
  // caused by #4702"
  std::string Text() const;

 private:
  const openr_host::System* system_;
  const openr_host::Message* message_;
  MessageKind kind_ = MessageKind::kOther;
  uint64_t number_ = 0;
  uint64_t cause_ = 0;
  int64_t time_us_ = 0;
  openr_host::ObjectId sender_ = openr_host::kNoObject;
  uint32_t sender_entry_ = 0;  // of the end of a connection it comes from
  openr_host::ObjectId target_ = openr_host::kNoObject;
  uint32_t selector_ = 0;
  uint32_t size_ = 0;
};

// "Blinker.Blink" for a service, the object's name where there is none.
std::string ShortName(const SeenMessage::End& end);

}  // namespace openr::testing
