#include "openr/live/message_history.h"

#include <OPENR/ObjcommMessages.h>

#include <algorithm>
#include <utility>

#include "runtime/core/api.h"
#include "runtime/core/system.h"

namespace openr_host {

std::string ServiceOfEntry(const Object& object, uint32_t selector) {
  const std::string name = object.EntryName(selector);
  return name.substr(0, name.find(" ("));
}

MessageHistory::~MessageHistory() { End(); }

void MessageHistory::Begin() {
  if (sink_ != 0) return;
  sink_ = system_.trace().AddSink(
      [this](const TraceRecord& record, const Message& message) { Keep(record, message); });
}

void MessageHistory::End() {
  if (sink_ == 0) return;
  system_.trace().RemoveSink(sink_);
  sink_ = 0;
  connections_.clear();
}

void MessageHistory::Keep(const TraceRecord& record, const Message& message) {
  Ends ends;
  if (message.kind == PayloadKind::kNotify) {
    const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
    ends = {ObjectIdOf(notify.subjectID.GetOID()), notify.subjectID.GetSelector(), message.target,
            message.selector};
  } else if (message.kind == PayloadKind::kReady) {
    const auto& ready = *reinterpret_cast<const OReadyMessage*>(message.payload);
    ends = {message.target, message.selector, ObjectIdOf(ready.observerID.GetOID()),
            ready.observerID.GetSelector()};
  } else {
    return;
  }
  ConnectionMessages& connection = connections_[ends];
  const auto& [subject_id, subject_selector, observer_id, observer_selector] = ends;
  const Object* const subject = system_.object(subject_id);
  const Object* const observer = system_.object(observer_id);
  const int loads = (subject == nullptr ? 0 : subject->predecessors()) +
                    (observer == nullptr ? 0 : observer->predecessors());
  if (connection.loads != loads) {
    connection = {};
    connection.loads = loads;
    if (subject != nullptr) connection.subject = ServiceOfEntry(*subject, subject_selector);
    if (observer != nullptr) connection.observer = ServiceOfEntry(*observer, observer_selector);
  }
  ++connection.count;
  std::string content = PayloadBytes(message);
  const auto size = static_cast<uint32_t>(content.size());
  content.resize(std::min(content.size(), kContentMax));
  if (connection.last.size() == kMessagesMax) connection.last.pop_front();
  connection.last.push_back({record.number, record.time_us, message.kind == PayloadKind::kReady,
                             size, std::move(content)});
}

const MessageHistory::ConnectionMessages* MessageHistory::Find(int robot,
                                                               const std::string& subject,
                                                               const std::string& observer) const {
  for (const auto& [ends, connection] : connections_) {
    const Object* const object = system_.object(std::get<0>(ends));
    if (object != nullptr && object->robot == robot && connection.subject == subject &&
        connection.observer == observer)
      return &connection;
  }
  return nullptr;
}

uint64_t MessageHistory::CountOf(int robot, const std::string& subject,
                                 const std::string& observer) const {
  const ConnectionMessages* const connection = Find(robot, subject, observer);
  return connection == nullptr ? 0 : connection->count;
}

std::vector<MessageHistory::Entry> MessageHistory::LastOf(int robot, const std::string& subject,
                                                          const std::string& observer) const {
  const ConnectionMessages* const connection = Find(robot, subject, observer);
  if (connection == nullptr) return {};
  return {connection->last.rbegin(), connection->last.rend()};
}

}  // namespace openr_host
