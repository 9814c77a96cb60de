// ObjectManager: the system's object that boots all other objects, makes their connections and
// shuts them down.  On the robot the object manager and the service manager do this.
//
// The object manager has the lowest priority, so its handlers continue only when no message of
// another object is due.  Therefore readies that a system service asserts in its DoStart are
// delivered before the first DoStart of the application (architecture.md, "Settled" 5).
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

  // Post a message of the object manager to itself.  Its handler does the work of Boot(),
  // Shutdown() or PostTask() of System, or of ObjectTable::Reload().
  void PostBoot();
  void PostShutdown(int robot);
  void PostReload(ObjectId id);
  void PostTask(std::function<void()> task);
  // Replaces objects of the system by the objects in `fresh`, which have the same ids, and boots
  // the new objects.  All objects are replaced before the first new object runs.  REQUIRES: called
  // in a handler of the object manager.
  void Begin(std::vector<std::unique_ptr<Object>> fresh);

  // Returns whether `message` must be kept back because its receiver is still in its boot.
  // - The first message that an object handles is DoInit.  On the robot DoInit is in the mailbox of
  //   the new object before any other object knows the new object (core.md, 1.5).
  // - A ready is kept back until the connections are made, because before that the subject does
  //   not know the observer.
  bool IsTooEarly(const Message& message) const {
    if (starting_.empty() || message.sender == host().id) return false;
    const auto found = starting_.find(message.target);
    if (found == starting_.end()) return false;
    if (message.kind == PayloadKind::kReady) return true;
    return !found->second && !HoldsUpBoot(message);
  }
  // Returns whether `message` is a request from an object that is itself in its boot.  Such a
  // message must not be held.  The DoInit of its sender waits for the reply, and the receiver's
  // DoInit may be sent only after that DoInit has returned.
  bool HoldsUpBoot(const Message& message) const {
    return message.reply_box != 0 && starting_.contains(message.sender);
  }
  // Notes that the DoInit of object `id` begins, so messages to the object need not be held any
  // more.  Only readies are held until the connections are made.
  void Begins(ObjectId id);

  // The virtual time after which a DoInit, DoStart, DoStop or DoDestroy that has not returned
  // becomes a finding.  This is our choice, because the robot's value is not known.
  static constexpr int64_t kReplyTimeoutUs = 10'000'000;

 private:
  void PostWith(Selector selector, int value);
  bool IsDue(Selector selector, int value);
  void RunBoot();
  void RefuseToStart();
  void RunShutdown(int robot);
  void RunReload(ObjectId id);
  void RunTask();
  // Calls `entry` (DoInit, DoStart, DoStop or DoDestroy) of `object` and waits until it has
  // returned.
  void Send(Object* object, Selector entry, OReason reason);
  // Calls Send() for all system objects, or for all other objects if `system_objects` is false.
  // The objects are those of `robot`, or of all robots.
  void SendToAll(Selector entry, OReason reason, bool system_objects, int robot = kAllRobots);
  void Connect(const struct Connection& connection);
  void ReleaseEarlyMessages();
  bool MayBeLost(int robot, const std::string& service) const;
  void ReportUnknown(const Connection& connection, const std::string& service);

  static constexpr int kAllRobots = -1;

  Selector boot_;
  Selector shutdown_;
  Selector reload_;
  Selector task_;
  // The selector and value of each message that the object manager has posted to itself and has not
  // handled yet.
  std::multiset<std::pair<Selector, int>> due_;
  std::deque<std::function<void()>> tasks_;
  std::set<int> shutting_down_;  // indices of robots whose shutdown has begun
  // objects to which DoInit could not be sent; they get no other call
  std::set<ObjectId> uninitialised_;
  // The objects that are in their boot.  The value is true if the DoInit of the object has begun.
  std::map<ObjectId, bool> starting_;
  bool are_connected_ = true;  // false while the connections of this boot are not made yet
  // Services that no object had registered when they were to be connected, each with its
  // connection.  At that time a worker process was lost, and its objects may register these
  // services after the restart of the process.  If the services are still unknown then, they become
  // findings.  The keys are addresses, so the code never iterates over this set: the order would
  // differ from run to run.
  std::set<std::pair<const struct Connection*, std::string>> unreported_;
};

}  // namespace openr_host
