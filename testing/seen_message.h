// SeenMessage, a message as a test sees it: just posted, refused, or about to be delivered.
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
  kNotReady,  // DeassertReady() of an observer, for a subject
  kReply,     // answer to a Call(), or to a Send() that wants an answer
  kOther,     // any other message: DoInit and the like, other handlers, messages of the system
};

// Returns "notify", "ready", "not ready" or "reply".  Returns null for kOther, because the name of
// the handler describes such a message better.
const char* WordFor(MessageKind kind);

class SeenMessage {
 public:
  // REQUIRES: `system` outlives this object.  `message` must still exist when data() or
  // data_count() is called; only a copy from Past() does not need the message.
  SeenMessage(const openr_host::System& system, const openr_host::Message& message);

  // Returns a copy that has no data(), but keeps the beginning of the data for Text().  The copy
  // can be used after the delivery, when the message no longer exists.
  SeenMessage Past() const;

  // Returns the number of the message; 0 if the message has no number yet or was refused.
  uint64_t number() const { return number_; }
  // Returns the number of the message whose handler sent this message.
  uint64_t cause() const { return cause_; }
  int64_t time_us() const { return time_us_; }
  MessageKind kind() const { return kind_; }
  uint32_t size() const { return size_; }  // number of bytes of data

  // The sender or the receiver of a message: an object and, for a connection, the full name of its
  // service ("Blinker.Blink.int.S").  Unknown names are empty.
  struct End {
    std::string_view object;
    std::string_view service;
  };
  End from() const;
  End to() const;
  // Returns the name of the receiver's handler, such as "DoStart" or "Alarm".  For a message of a
  // connection or a reply, returns the word of WordFor() instead, such as "notify".
  std::string entry() const;

  // Returns the number of data in the message.  A notification may have several data.  Any other
  // message has one datum, the bytes of its payload, or no data.  A copy from Past() has no data.
  int data_count() const;
  // Returns the bytes of datum `i`.  REQUIRES: 0 <= i < data_count().
  std::string_view data(int i) const;

  // Returns a description such as "#4711 t=1.248000 RCServer.Mover -> JointMover.Mover notify, 84
  // bytes, caused by #4702: move neck_pan to 30.00 deg".  Data of a type that only the user's
  // objects define are shown as text or as numbers.
  std::string Text() const;

 private:
  std::string Content() const;

  const openr_host::System* system_;
  const openr_host::Message* message_;
  MessageKind kind_ = MessageKind::kOther;
  uint64_t number_ = 0;
  uint64_t cause_ = 0;
  int64_t time_us_ = 0;
  openr_host::ObjectId sender_ = openr_host::kNoObject;
  // Number of the handler that the sender has for its end of the connection; 0: the message is of
  // no connection.
  uint32_t sender_entry_ = 0;
  openr_host::ObjectId target_ = openr_host::kNoObject;
  uint32_t selector_ = 0;
  uint32_t size_ = 0;
  // The first bytes of the message's data.  Set only in a SeenMessage that Past() has made, because
  // the message itself may be gone then.
  std::string content_;
};

// Returns the first two parts of the service's name, "Blinker.Blink"; without a service, the
// object's name.
std::string ShortName(const SeenMessage::End& end);

}  // namespace openr::testing
