// The object manager and the service manager of the system, in one object: boot,
// connections, shutdown.
//
// It has the lowest priority, so it goes on only when no message of an object is
// due: what a system service asserted has been delivered before the first DoStart
// of the application (architecture.md, "Settled" 5).
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

  void PostBoot();
  void PostShutdown(int robot);
  void PostReload(ObjectId id);
  void PostTask(std::function<void()> task);
  // Objects take the place of those with their ids, all before one of them runs, and begin.  In
  // one of the manager's handlers.
  void Begin(std::vector<std::unique_ptr<Object>> fresh);

  // Whether its receiver does not hear `message` yet: the first of all is DoInit, as on the robot,
  // where it lies in the mailbox before anybody else knows of the object (core.md, 1.5); a ready
  // waits until the connections are made, or its observer would be unknown.
  bool IsTooEarly(const Message& message) const {
    if (starting_.empty() || message.sender == host().id) return false;
    const auto found = starting_.find(message.target);
    if (found == starting_.end()) return false;
    if (message.kind == PayloadKind::kReady) return true;
    return !found->second && !HoldsUpBoot(message);
  }
  // A question in somebody's DoInit: with the answer the others' would wait.
  bool HoldsUpBoot(const Message& message) const {
    return message.reply_box != 0 && starting_.contains(message.sender);
  }
  // The DoInit of object `id` begins.
  void Begins(ObjectId id);

  // How long a DoXxx may wait before it is reported (the robot's value is not
  // known; virtual time).
  static constexpr int64_t kReplyTimeoutUs = 10'000'000;

 private:
  void PostWith(Selector selector, int value);
  bool IsDue(Selector selector, int value);
  void RunBoot();
  void RefuseToStart();
  void RunShutdown(int robot);
  void RunReload(ObjectId id);
  void RunTask();
  void Send(Object* object, Selector entry, OReason reason);
  // To the objects of `robot`, or of all.
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
  std::multiset<std::pair<Selector, int>> due_;  // what it has sent itself
  std::deque<std::function<void()>> tasks_;
  std::set<int> shutting_down_;        // robots
  std::set<ObjectId> uninitialised_;   // never heard of DoInit
  std::map<ObjectId, bool> starting_;  // not connected yet; whether it has heard of DoInit
  bool are_connected_ = true;          // false as long as those in `starting_` wait for that
  // Services that are not there as long as something is lost; looked up only.
  std::set<std::pair<const struct Connection*, std::string>> unreported_;
};

}  // namespace openr_host
