#include "runtime/core/post_as_object.h"

#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>
#include <fmt/format.h>

#include <cstring>
#include <new>
#include <utility>

#include "runtime/core/api.h"
#include "runtime/core/subject_state.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

constexpr char kFull[] = "the queue of the receiver is full";

// Returns "" if the subject and the observer are connected, otherwise an error message.
std::string NotConnectedText(const System& system, const ServiceEnd& subject,
                             const ServiceEnd& observer) {
  const OServiceEntry observer_id(OidOf(observer.object), observer.selector);
  for (const auto& each : system.object(subject.object)->subjects()) {
    if (each->id.selector != subject.selector) continue;
    if (each->Find(observer_id) != nullptr) return "";
    return fmt::format("{} is not connected with {}", each->service,
                       system.object(observer.object)->EntryName(observer.selector));
  }
  return fmt::format("{} is in another process, or its object does not use it",
                     system.object(subject.object)->EntryName(subject.selector));
}

}  // namespace

bool NamesService(std::string_view name, std::string_view service) {
  if (!service.starts_with(name)) return false;
  return service.size() == name.size() || service[name.size()] == '.';
}

std::optional<ServiceEnd> FindService(const System& system, int robot, std::string_view name,
                                      ServiceSide side) {
  const std::string_view kind = side == ServiceSide::kSubject ? " (Ready)" : " (Notify)";
  for (const auto& object : system.objects()) {
    if (object->robot != robot) continue;
    for (const auto& [selector, entry] : object->entry_names().names()) {
      if (!entry.ends_with(kind)) continue;
      const std::string_view service(entry.data(), entry.size() - kind.size());
      if (NamesService(name, service)) return ServiceEnd{object->id, selector};
    }
  }
  return std::nullopt;
}

std::vector<std::string> SubjectsOf(const System& system, int robot, std::string_view observer) {
  std::vector<std::string> subjects;
  for (const Connection& connection : system.connections()) {
    if (connection.robot == robot && NamesService(observer, connection.observer))
      subjects.push_back(connection.subject);
  }
  return subjects;
}

std::string PostNotification(System* system, const ServiceEnd& subject, const ServiceEnd& observer,
                             std::string_view datum) {
  if (std::string why = NotConnectedText(*system, subject, observer); !why.empty()) return why;
  if (datum.size() > kRobotMemoryBytes)
    return fmt::format("{} bytes of data are more than the {} MiB that a region has at most",
                       datum.size(), kRobotMemoryBytes >> 20);
  // Makes the subject's object the current object, so that this object is the sender of the
  // notification.
  const CurrentScope scope(system, system->object(subject.object));
  RCRegion* const region = new RCRegion(datum.size());
  std::memcpy(region->Base(), datum.data(), datum.size());
  OwnedMessage message = system->NewMessage(observer.object, observer.selector);
  auto& notify = *new (message->payload) ONotifyMessage;
  notify.msgType = omsgNOTIFY_V22;
  notify.subjectID = OServiceEntry(OidOf(subject.object), subject.selector);
  notify.numOfData = 1;
  notify.numOfNotify = 1;
  notify.data[0].srcRCR = region;
  notify.data[0].memID = region->MemID();
  notify.data[0].offset = region->Offset();
  notify.data[0].size = region->Size();
  message->size = sizeof notify;
  message->kind = PayloadKind::kNotify;
  if (system->Post(std::move(message)) == sSUCCESS) return "";
  // Post() has refused the notification, so no observer will give the region back.  Gives up the
  // only reference to the region, which deletes it.
  region->RemoveReference();
  return kFull;
}

std::string PostReady(System* system, const ServiceEnd& observer, const ServiceEnd& subject,
                      bool is_ready) {
  if (std::string why = NotConnectedText(*system, subject, observer); !why.empty()) return why;
  // Makes the observer's object the current object, so that this object is the sender of the ready.
  const CurrentScope scope(system, system->object(observer.object));
  OwnedMessage message = system->NewMessage(subject.object, subject.selector);
  auto& ready = *new (message->payload) OReadyMessage;
  ready.msgType = omsgREADY_V22;
  ready.command = is_ready ? objcommCMD_ASSERT_READY : objcommCMD_DEASSERT_READY;
  ready.observerID = OServiceEntry(OidOf(observer.object), observer.selector);
  ready.numOfData = 0;
  message->size = sizeof ready;
  message->kind = PayloadKind::kReady;
  return system->Post(std::move(message)) == sSUCCESS ? "" : kFull;
}

}  // namespace openr_host
