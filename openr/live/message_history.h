// MessageHistory, which keeps the last messages of each connection of a run, for people who look at
// the run.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class System;
class Object;
struct Message;
struct TraceRecord;

// Returns the name of the service that the entry `selector` of `object` belongs to:
// "RCServer.Move.MoveCommand.S".
std::string ServiceOfEntry(const Object& object, uint32_t selector);

class MessageHistory {
 public:
  struct Entry {
    uint64_t number;
    int64_t time_us;
    bool is_ready;        // a ready of the observer; otherwise a notification of the subject
    uint32_t size;        // bytes of the content
    std::string content;  // the content, as in a recording; at most kContentMax bytes of it
  };

  // Limits of what is kept: messages of a connection, and bytes of a message.
  static constexpr size_t kMessagesMax = 20;
  static constexpr size_t kContentMax = 16384;  // a sensor vector of any robot fits

  // `system` must outlive the history.
  explicit MessageHistory(System* system) : system_(*system) {}
  ~MessageHistory();
  MessageHistory(const MessageHistory&) = delete;
  MessageHistory& operator=(const MessageHistory&) = delete;

  // Begins and ends to keep messages.  To end it forgets all messages.
  void Begin();
  void End();

  // Returns how many messages the ends of a connection have sent each other since Begin().
  uint64_t CountOf(int robot, const std::string& subject, const std::string& observer) const;
  // Returns the last messages between the service `subject` and the service `observer` of a robot,
  // the newest first.  Both are full names: "RCServer.Mover.MoverCommand.S".
  std::vector<Entry> LastOf(int robot, const std::string& subject,
                            const std::string& observer) const;

 private:
  // A connection: the entry of the subject, then that of the observer.
  using Ends = std::tuple<ObjectId, uint32_t, ObjectId, uint32_t>;

  struct ConnectionMessages {
    std::string subject;  // names of both services
    std::string observer;
    int loads = -1;  // how often objects of these two ids were loaded again when they were named
    uint64_t count = 0;
    std::deque<Entry> last;
  };

  void Keep(const TraceRecord& record, const Message& message);
  const ConnectionMessages* Find(int robot, const std::string& subject,
                                 const std::string& observer) const;

  System& system_;
  int sink_ = 0;  // 0: no messages are kept now
  std::map<Ends, ConnectionMessages> connections_;
};

}  // namespace openr_host
