// MessageHistory, which keeps the last messages of each connection of a run, so that people can
// look at them.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "openr/decode/decode_message.h"
#include "runtime/core/message.h"

namespace openr_host {

class System;
class Object;
struct Message;
struct TraceRecord;

// Returns the name of the service to which the entry `selector` of `object` belongs, such as
// "RCServer.Move.MoveCommand.S".
std::string ServiceOfEntry(const Object& object, uint32_t selector);

class MessageHistory {
 public:
  struct Entry {
    uint64_t number;
    int64_t time_us;
    // True: a ready message of the observer; false: a notification of the subject.
    bool is_ready;
    uint32_t size;        // number of bytes of the whole content
    std::string content;  // the content, from PayloadBytes(), cut to kContentMax bytes
  };

  // The largest number of messages that are kept for a connection.
  static constexpr size_t kMessagesMax = 20;
  // The largest number of bytes of a message's content that are kept.  A sensor vector of any robot
  // has fewer bytes, so it is kept whole.
  static constexpr size_t kContentMax = kDecodedBytesMax;

  // Makes a history of the messages in `system`, which must outlive the history.
  explicit MessageHistory(System* system) : system_(*system) {}
  ~MessageHistory();
  MessageHistory(const MessageHistory&) = delete;
  MessageHistory& operator=(const MessageHistory&) = delete;

  // Begins to keep messages for the history.
  void Begin();
  // Stops keeping messages, and forgets the kept messages.
  void End();

  // Returns the number of messages that both ends of a connection have sent to each other since the
  // call of Begin().
  uint64_t CountOf(int robot, const std::string& subject, const std::string& observer) const;
  // Returns the last messages between the service `subject` and the service `observer` of a robot,
  // the newest message first.  Both services are given by their full names, such as
  // "RCServer.Mover.MoverCommand.S".
  std::vector<Entry> LastOf(int robot, const std::string& subject,
                            const std::string& observer) const;

 private:
  // Identifies a connection: object and selector of its subject, then object and selector of its
  // observer.
  using Ends = std::tuple<ObjectId, uint32_t, ObjectId, uint32_t>;

  struct ConnectionMessages {
    std::string subject;  // names of the services at the two ends of the connection
    std::string observer;
    // Number of times that the objects at both ends had been replaced when the names `subject` and
    // `observer` were set; -1: the names are not set yet.  If an object is replaced again, the kept
    // messages are dropped and both names are looked up again.
    int loads = -1;
    uint64_t count = 0;
    std::deque<Entry> last;
  };

  void Keep(const TraceRecord& record, const Message& message);
  const ConnectionMessages* Find(int robot, const std::string& subject,
                                 const std::string& observer) const;

  System& system_;
  int sink_ = 0;  // id of the function that the trace calls for each message; 0: no such function
  std::map<Ends, ConnectionMessages> connections_;
};

}  // namespace openr_host
