// ObjectManager: the system's object that boots all other objects, makes their connections and
// shuts them down.  On the robot the object manager and the service manager do this.
//
// The object manager boots objects one after the other: it sends DoInit or DoStart to an object and
// waits for the reply.  It has the lowest priority, so it continues only when no message of another
// object is due.  Therefore, if a system service asserts ready in its DoStart, the connected
// subject gets this ready before the first DoStart of the application.  On the robot, too, readies
// can come before DoStart (core.md 1.5).
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/code_object.h"

namespace openr_host {

class ObjectManager : public CodeObject {
 public:
  ObjectManager();

  // The next five functions each post a message from the object manager to itself, so that the work
  // is done in a handler, which can wait for replies.  System::Boot(), System::PostTask() and
  // ObjectTable::Reload() call them.  They are also called when a robot shuts down and when it
  // boots again.
  void PostBoot();
  void PostShutdown(int robot);
  void PostBootAgain(int robot);
  void PostReload(ObjectId id);
  void PostTask(std::function<void()> task);
  // Replaces objects of the system by the objects in `fresh`, which have the same ids, and boots
  // the new objects.  All objects are replaced before the first new object runs.  REQUIRES: called
  // in a handler of the object manager.
  void ReplaceAndBoot(std::vector<std::unique_ptr<Object>> fresh);

  // Returns whether the last DoStart of the first boot has returned.
  bool has_booted() const { return has_booted_; }

  // Returns whether `message` must be kept back because its receiver is still in its boot:
  // - Until the DoInit of the receiver begins, any message is kept back, because DoInit must be the
  //   first message.  On the robot DoInit is in the mailbox of the new object before any other
  //   object knows the new object (core.md, 1.5).
  // - Until the connections are made, a ready is kept back, because the subject does not know the
  //   observer before.
  bool IsTooEarly(const Message& message) const {
    if (starting_.empty() || message.sender == host().id) return false;
    const auto found = starting_.find(message.target);
    if (found == starting_.end()) return false;
    if (message.kind == PayloadKind::kReady) return true;
    return !found->second && !WouldBlockBoot(message);
  }
  // Returns whether IsTooEarly() keeps messages back, that is, whether an object is in its boot.
  bool HoldsMessages() const { return !starting_.empty(); }
  // Returns whether `message` is a request from an object that is itself in its boot.  If this
  // message were kept back, the boot would not go on: the sender waits for the reply in its DoInit,
  // and the receiver gets its own DoInit only after the DoInit of the sender has returned.
  bool WouldBlockBoot(const Message& message) const {
    return message.reply_box != 0 && starting_.contains(message.sender);
  }
  // Records that the DoInit of object `id` begins.  Until now IsTooEarly() has kept back all
  // messages to the object.  From now on it keeps back only readies, until the connections are
  // made.
  void NoteInitBegins(ObjectId id);

  // The virtual time after which a DoInit, DoStart, DoStop or DoDestroy that has not returned
  // becomes a finding.  This is our choice, because the robot's value is not known.
  static constexpr int64_t kReplyTimeoutUs = 10'000'000;

 private:
  void PostWith(Selector selector, int value);
  bool IsDue(Selector selector, int value);
  void RunBoot(int robot, size_t findings_before);
  void RunBootAgain(int robot);
  void RefuseToStart(int robot);
  void HoldMessages(int robot);
  void RunShutdown(int robot);
  void RunReload(ObjectId id);
  void RunTask();
  // Calls `entry` (DoInit, DoStart, DoStop or DoDestroy) of `object` with the `reason` (boot or
  // shutdown), and waits until it has returned.
  void Send(Object* object, Selector entry, OReason reason);
  // Calls Send() for all system objects (parts of the robot), or for all other objects if
  // `system_objects` is false.  There are two calls for each step, because system objects boot
  // before the others and shut down after them.  The objects are those of `robot`, or of all
  // robots.
  void SendToAll(Selector entry, OReason reason, bool system_objects, int robot = kAllRobots);
  void Connect(const struct Connection& connection);
  void ReleaseEarlyMessages();
  bool MayBeLost(int robot, const std::string& service) const;
  void ReportUnknown(const Connection& connection, const std::string& service);

  static constexpr int kAllRobots = -1;

  Selector boot_;
  Selector boot_again_;
  Selector shutdown_;
  Selector reload_;
  Selector task_;
  // The messages that the object manager has posted to itself and has not handled yet.  Each is
  // stored as its selector and the value in its payload (a robot or an object id).  IsDue() refuses
  // a message that is not in this set.
  std::multiset<std::pair<Selector, int>> due_;
  // The tasks of PostTask() that were not called yet, oldest first.
  std::deque<std::function<void()>> tasks_;
  bool has_booted_ = false;
  std::set<int> shutting_down_;  // indices of robots whose shutdown has begun
  // The objects to which DoInit could not be sent.  They get no DoStart, DoStop or DoDestroy
  // either.
  std::set<ObjectId> uninitialised_;
  // The objects that are in their boot, for which IsTooEarly() keeps messages back.  The value is
  // true if the DoInit of the object has begun; then only readies are kept back.
  std::map<ObjectId, bool> starting_;
  bool are_connected_ = true;  // false while the connections of this boot are not made yet
  // Pairs of a connection and the name of one of its services, which was not registered when the
  // connection had to be made.  Only services that may belong to a lost worker process are kept
  // here (MayBeLost()), because a restart of the process may register them.  After the restart,
  // ReplaceAndBoot() reports the services that are still not registered.  The order of the pairs
  // differs from run to run, because it depends on addresses.  So the code never iterates over this
  // set.
  std::set<std::pair<const struct Connection*, std::string>> unreported_;
};

}  // namespace openr_host
