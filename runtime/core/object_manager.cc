#include "runtime/core/object_manager.h"

#include <fmt/format.h>

#include <cstring>
#include <map>
#include <optional>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/base/spelling.h"
#include "runtime/config/service_name.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_messages.h"
#include "runtime/core/dispatcher.h"
#include "runtime/core/image_object.h"
#include "runtime/core/load_image.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

// Returns the message that calls DoInit, DoStart, DoStop or DoDestroy of `object`.  A message with
// the reason boot carries the state of the Memory Stick; a message with any other reason carries an
// OShutdownParam.  No document says so; we infer it from the names of these types (core.md, 1.4).
OReasonMessage MessageOf(const Object& object, OReason reason) {
  if (reason != oreasonBOOT) {
    const OShutdownParam param(true);
    return OReasonMessage(reason, &param, sizeof param);
  }
  System& system = *object.system;
  const MemoryStick* const stick =
      object.robot < system.robot_count() ? system.robot(object.robot).stick.get() : nullptr;
  const OBootParam param(stick == nullptr    ? omemorystickNOT_EXIST
                         : stick->writable() ? omemorystickWRITABLE
                                             : omemorystickWRITE_PROTECTED);
  return OReasonMessage(reason, &param, sizeof param);
}

const char* const kEntryWords[] = {"DoInit", "DoStart", "DoStop", "DoDestroy"};

}  // namespace

ObjectManager::ObjectManager() {
  boot_ = AddExtra("Boot", [this](void*) {
    if (!IsDue(boot_, 0)) return;
    system().inputs().DoBeforeBoot();
    RunBoot(kAllRobots, 0);
  });
  shutdown_ = AddExtra("Shutdown", [this](void* message) {
    const int robot = *static_cast<int*>(message);
    if (IsDue(shutdown_, robot)) RunShutdown(robot);
  });
  reload_ = AddExtra("Reload", [this](void* message) {
    const ObjectId id = *static_cast<ObjectId*>(message);
    if (IsDue(reload_, id)) RunReload(id);
  });
  task_ = AddExtra("Task", [this](void*) {
    if (IsDue(task_, 0)) RunTask();
  });
  boot_again_ = AddExtra("BootAgain", [this](void* message) {
    const int robot = *static_cast<int*>(message);
    if (IsDue(boot_again_, robot)) RunBootAgain(robot);
  });
}

// Begins to keep back the messages to the objects of `robot`, or of all robots.  IsTooEarly() says
// which messages are kept back, and for how long.
void ObjectManager::HoldMessages(int robot) {
  are_connected_ = false;
  system().dispatcher().CheckDeliveries();
  for (const auto& object : system().objects()) {
    if (object == nullptr || object->is_system() || object->is_absent()) continue;
    if (robot == kAllRobots || object->robot == robot) starting_.emplace(object->id, false);
  }
}

void ObjectManager::PostBoot() {
  HoldMessages(kAllRobots);
  due_.insert({boot_, 0});
  system().Post(system().NewMessage(host().id, boot_));
}

void ObjectManager::PostShutdown(int robot) {
  if (!shutting_down_.insert(robot).second) return;
  PostWith(shutdown_, robot);
}

void ObjectManager::PostBootAgain(int robot) { PostWith(boot_again_, robot); }

void ObjectManager::PostReload(ObjectId id) { PostWith(reload_, id); }

void ObjectManager::PostTask(std::function<void()> task) {
  tasks_.push_back(std::move(task));
  due_.insert({task_, 0});
  system().Post(system().NewMessage(host().id, task_));
}

void ObjectManager::PostWith(Selector selector, int value) {
  due_.insert({selector, value});
  OwnedMessage message = system().NewMessage(host().id, selector);
  std::memcpy(message->payload, &value, sizeof value);
  message->size = sizeof value;
  system().Post(std::move(message));
}

// Returns whether the object manager itself has posted the message with this selector and value (a
// robot or an object id).  If so, removes the message from due_, because it is handled now.
// Otherwise adds an error finding, because every object can send a message with this selector.
bool ObjectManager::IsDue(Selector selector, int value) {
  const auto found = due_.find({selector, value});
  if (found != due_.end()) {
    due_.erase(found);
    return true;
  }
  system().AddFindingAbout(
      system().object(host().running()->sender), Severity::kError,
      fmt::format("a message to the object manager that only the system sends: {}; nothing is done",
                  host().EntryName(selector)));
  return false;
}

void ObjectManager::NoteInitBegins(ObjectId id) {
  const auto found = starting_.find(id);
  if (found == starting_.end()) return;
  found->second = true;
  if (are_connected_) starting_.erase(found);
}

// Puts the messages that were held during the boot back into the queue, because the connections are
// made now.  Messages to an object whose DoInit has not begun stay held, because DoInit must be the
// first message that an object handles.
void ObjectManager::ReleaseEarlyMessages() {
  are_connected_ = true;
  for (auto next = starting_.begin(); next != starting_.end();) {
    const auto starting = next++;
    if (!starting->second) continue;
    Object* const object = system().object(starting->first);
    starting_.erase(starting);
    if (object->delivery().blocked() == nullptr && !object->delivery().is_busy())
      object->ReturnHeld();
  }
}

// Boots `robot`, or all robots if `robot` is kAllRobots.  `findings_before` is the number of
// findings before this boot; all later findings about `robot` count as findings about the boot.
void ObjectManager::RunBoot(int robot, size_t findings_before) {
  SendToAll(oentryINIT, oreasonBOOT, true, robot);
  SendToAll(oentryINIT, oreasonBOOT, false, robot);
  for (const Connection& connection : system().connections()) {
    if (robot == kAllRobots || connection.robot == robot) Connect(connection);
  }
  ReleaseEarlyMessages();
  // When one robot boots again, ignores errors about other robots, which do not boot now.
  const std::optional<int> of_robot = robot == kAllRobots ? std::nullopt : std::optional(robot);
  if (system().options().strict && system().findings().HasError(findings_before, of_robot)) {
    RefuseToStart(robot);
    return;
  }
  SendToAll(oentrySTART, oreasonBOOT, true, robot);
  SendToAll(oentrySTART, oreasonBOOT, false, robot);
  has_booted_ = true;
}

// Boots `robot` again after it was off.  Loads all images of the robot again.
void ObjectManager::RunBootAgain(int robot) {
  const size_t findings_before = system().findings().all().size();
  shutting_down_.erase(robot);
  // Clears unreported_, the unknown services that may still become findings, because its keys hold
  // addresses of connections, and LoadAgain() makes all connections of the robot anew.  No finding
  // is lost: unreported_ has only services of lost processes, and a robot with objects in other
  // processes does not boot again.
  unreported_.clear();
  if (!system().robot_table().LoadAgain(robot)) return;
  HoldMessages(robot);
  RunBoot(robot, findings_before);
}

// Switches `robot`, or all robots, off during the boot.  Called with --strict if there is an error,
// for example a connection to an unknown service.  The objects have run their DoInit by then,
// because an unknown service is found only after DoInit has registered all services.
void ObjectManager::RefuseToStart(int robot) {
  for (int each = 0; each < system().robot_count(); ++each) {
    if (robot != kAllRobots && each != robot) continue;
    system().PowerOff(each,
                      {EndKind::kNoBoot, "--strict refuses wrong wiring; no object was started"});
  }
}

void ObjectManager::RunShutdown(int robot) {
  SendToAll(oentrySTOP, oreasonSHUTDOWN, false, robot);
  SendToAll(oentrySTOP, oreasonSHUTDOWN, true, robot);
  SendToAll(oentryDESTROY, oreasonSHUTDOWN, false, robot);
  SendToAll(oentryDESTROY, oreasonSHUTDOWN, true, robot);
  system().PowerOff(robot);
}

// Replaces object `id` by a new load of its image file.  The file is loaded before the old object
// is stopped, so nothing changes if it cannot be loaded.
void ObjectManager::RunReload(ObjectId id) {
  Object* const old = system().object(id);
  if (old == nullptr || !old->is_image())
    return;  // only an object that this process has loaded from a file can be loaded again
  std::unique_ptr<Object> fresh = OpenImage(&system(), old->robot, old->id, old->path, "reload");
  if (fresh == nullptr) return;
  Send(old, oentrySTOP, oreasonSHUTDOWN);
  Send(old, oentryDESTROY, oreasonSHUTDOWN);
  std::vector<std::unique_ptr<Object>> all;
  all.push_back(std::move(fresh));
  ReplaceAndBoot(std::move(all));
}

void ObjectManager::RunTask() {
  ASSERT(!tasks_.empty(), "a task was posted and is not in the list");
  const std::function<void()> task = std::move(tasks_.front());
  tasks_.pop_front();
  task();
}

void ObjectManager::ReplaceAndBoot(std::vector<std::unique_ptr<Object>> fresh) {
  are_connected_ = false;
  system().dispatcher().CheckDeliveries();
  for (const auto& object : fresh) starting_[object->id] = false;
  ObjectTable::Readies readies = system().object_table().Replace(std::move(fresh));
  // Some observers have asserted ready to an old object and do not know that it was replaced.
  // Sends their readies to the new object once more.  Sends them before DoInit; the object manager
  // keeps them back until the connections are made.  So a ready or deassert that such an observer
  // sends meanwhile comes later and replaces its old ready.  Leaves out an observer that is
  // replaced too, because it asserts ready in its own boot.
  for (auto& [id, standing] : readies) {
    std::erase_if(standing, [&](const auto& one) { return readies.contains(one.observer); });
    system().object_table().AssertAgain(id, standing);
  }
  for (const auto& [id, standing] : readies) Send(system().object(id), oentryINIT, oreasonBOOT);
  // Makes the connections that begin or end at a new object.  For the other connections, reports
  // the services in unreported_ that no object has registered.  They were not reported before,
  // because they might have belonged to a lost worker process.
  for (const Connection& connection : system().connections()) {
    const auto& directory = system().robot(connection.robot).directory;
    const auto is_fresh = [&](const std::string& service) {
      const auto found = directory.find(service);
      return found != directory.end() && readies.contains(found->second.first);
    };
    const bool no_subject = unreported_.erase({&connection, connection.subject}) > 0;
    const bool no_observer = unreported_.erase({&connection, connection.observer}) > 0;
    if (is_fresh(connection.subject) || is_fresh(connection.observer)) {
      Connect(connection);
      continue;
    }
    if (no_subject) ReportUnknown(connection, connection.subject);
    if (no_observer) ReportUnknown(connection, connection.observer);
  }
  ReleaseEarlyMessages();
  for (const auto& [id, standing] : readies) Send(system().object(id), oentrySTART, oreasonBOOT);
}

void ObjectManager::SendToAll(Selector entry, OReason reason, bool system_objects, int robot) {
  std::vector<ObjectId> left;
  for (const auto& object : system().objects()) {
    if (object == nullptr || object.get() == &host() || object->is_system() != system_objects)
      continue;
    if (robot == kAllRobots || object->robot == robot) left.push_back(object->id);
  }
  // Lets the schedule choose the order of the objects for DoStart and for no other entry, because
  // the robot guarantees no order of the DoStarts (core.md 1.5).
  Schedule* const schedule = entry == oentrySTART ? system().poster().schedule() : nullptr;
  while (!left.empty()) {
    const size_t next = schedule == nullptr || left.size() == 1
                            ? 0
                            : schedule->Choose(Schedule::Question::kStart, left);
    Send(system().object(left[next]), entry, reason);
    left.erase(left.begin() + static_cast<ptrdiff_t>(next));
  }
}

void ObjectManager::Send(Object* object, Selector entry, OReason reason) {
  if (entry == oentryINIT) uninitialised_.erase(object->id);
  if (uninitialised_.contains(object->id))
    return;  // sends nothing more: without DoInit the object has no subjects or observers
  // The robot of `object` has been switched off before this call.
  if (object->delivery().is_off()) return;
  OReasonMessage message = MessageOf(*object, reason);
  OStatusMessage reply;
  const sError error = system().requests().Call(object->id, entry, &message, sizeof message, &reply,
                                                sizeof reply, kReplyTimeoutUs);
  if (error == sTIMEOUT) {
    system().AddFindingAbout(
        object, Severity::kError,
        fmt::format(
            "{} did not return within {} s: OObjectRegistry::SendWithRBoxObjects() : Receive() "
            "oid {:x} selector {} error {}",
            kEntryWords[entry], kReplyTimeoutUs / 1'000'000, OidValue(object->id), entry, error));
  } else if (error != sSUCCESS) {
    system().AddFindingAbout(
        object, Severity::kError,
        fmt::format("{} could not be sent, error {}{}", kEntryWords[entry], error,
                    entry == oentryINIT ? "; the object takes no part in the run" : ""));
    if (entry == oentryINIT) uninitialised_.insert(object->id);
  } else if (reply.status != oSUCCESS) {
    system().AddFindingAbout(object, Severity::kWarning,
                             fmt::format("{} returned status {}; the robot's answer to that is not "
                                         "known, the run goes on",
                                         kEntryWords[entry], reply.status));
  }
}

// Returns whether `service` may be unknown only because the process of its object is lost.  The
// name of the object may differ from the first part of the service's name.  So the object is
// searched for in two steps:
// 1. the object whose name is the first part of the service's name,
// 2. else the object of a registered service whose name has the same first part.
// If an object is found, returns whether this object is lost.  Otherwise returns whether any object
// of the robot is lost, because the service may belong to that object.
bool ObjectManager::MayBeLost(int robot, const std::string& service) const {
  const std::string prefix = service.substr(0, service.find('.') + 1);
  bool has_lost = false;
  for (const auto& object : system().objects()) {
    if (object == nullptr || object->robot != robot) continue;
    has_lost = has_lost || object->is_lost();
    if (object->name + '.' == prefix) return object->is_lost();
  }
  for (const auto& [name, entry] : system().robot(robot).directory) {
    if (name.starts_with(prefix)) return system().object(entry.first)->is_lost();
  }
  return has_lost;
}

void ObjectManager::ReportUnknown(const Connection& connection, const std::string& service) {
  // Keeps the unknown service of a lost process in unreported_ and does not report it now: the loss
  // of the process has been reported, and the process may come back.
  if (MayBeLost(connection.robot, service)) {
    unreported_.emplace(&connection, service);
    return;
  }
  std::string why =
      "no object registered it in DoInit (REGISTER_ALL_ENTRY missing, or the object is not in "
      "OBJECT.CFG)";
  std::vector<std::string> known;
  const std::string object = service.substr(0, service.find('.') + 1);
  std::string cause = object;  // replaced by `service` below if the object has registered a service
  const auto wanted = ParseServiceName(service, nullptr);
  for (const auto& [name, entry] : system().robot(connection.robot).directory) {
    known.push_back(name);
    // The object has registered the service `name`, so the object is not missing.  Makes the
    // service the cause of the finding, and not the object.
    if (name.starts_with(object)) cause = service;
    const auto registered = ParseServiceName(name, nullptr);
    if (!wanted || !registered || !DifferInDataOnly(*wanted, *registered)) continue;
    why = fmt::format("syntax error, the object registered it with data '{}', not '{}'",
                      registered->data, wanted->data);
  }
  const char* const consequence =
      system().options().strict ? "--strict: no object starts" : "the line is skipped";
  system().AddFindingAboutRobot(
      connection.robot, Severity::kError,
      fmt::format("{}: OServiceManager::Connect() : {} NOT FOUND{}: {}; {}", connection.where,
                  service, DidYouMean(service, known), why, consequence),
      "NOT FOUND " + cause, connection.where);
}

void ObjectManager::Connect(const Connection& connection) {
  const auto& directory = system().robot(connection.robot).directory;
  const auto subject = directory.find(connection.subject);
  const auto observer = directory.find(connection.observer);
  if (subject == directory.end()) ReportUnknown(connection, connection.subject);
  if (observer == directory.end()) ReportUnknown(connection, connection.observer);
  if (observer == directory.end()) return;

  // Makes no connection to or from a lost process now; the connection is made when that process is
  // back.  If only the process of the subject is lost, sends the observer a connect message
  // nevertheless, so that the observer keeps its readies for the subject.
  const auto is_subject_lost = [&] {
    return subject == directory.end() ? MayBeLost(connection.robot, connection.subject)
                                      : system().object(subject->second.first)->is_lost();
  };
  const auto is_observer_lost = [&] { return system().object(observer->second.first)->is_lost(); };
  const bool was_subject_lost = is_subject_lost();
  if (is_observer_lost() || (subject == directory.end() && !was_subject_lost)) return;
  OConnectMessage message;
  std::memset(static_cast<void*>(&message), 0, sizeof message);
  message.msgType = was_subject_lost ? kConnectToLost : omsgCONNECT;
  message.command = oconnectcmdCONNECT;
  if (!was_subject_lost)
    message.entry = OServiceEntry(OidOf(subject->second.first), subject->second.second);
  std::strncpy(message.subName, connection.subject.c_str(), sizeof message.subName - 1);
  OStatusMessage reply;
  const sError error =
      system().requests().Call(observer->second.first, observer->second.second, &message,
                               sizeof message, &reply, sizeof reply, kReplyTimeoutUs);
  // Adds no finding about this connection if the process of the subject or of the observer is lost,
  // because the loss is a finding already.  The process may also have been lost while the object
  // manager waited for the reply to the connect message.
  if (was_subject_lost || is_subject_lost() || is_observer_lost()) return;
  if (error != sSUCCESS || reply.status != oSUCCESS) {
    system().AddFindingAboutRobot(
        connection.robot, Severity::kError,
        fmt::format("{}: connection refused: {} -> {}: status {}", connection.where,
                    connection.subject, connection.observer,
                    error != sSUCCESS ? static_cast<longword>(error) : reply.status));
  }
}

}  // namespace openr_host
