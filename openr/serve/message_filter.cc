#include "openr/serve/message_filter.h"

#include <OPENR/ObjcommMessages.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "openr/live/message_history.h"
#include "runtime/base/spelling.h"
#include "runtime/core/api.h"
#include "runtime/core/post_as_object.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

constexpr const char* kKinds[] = {"notify", "ready", "not ready", "reply", "other"};

std::string KindOf(const Message& message) {
  if (message.is_reply) return "reply";
  if (message.kind == PayloadKind::kNotify) return "notify";
  if (message.kind != PayloadKind::kReady) return "other";
  const auto& ready = *reinterpret_cast<const OReadyMessage*>(message.payload);
  return ready.command == objcommCMD_ASSERT_READY ? "ready" : "not ready";
}

std::string NameOf(const System& system, ObjectId id) {
  const Object* const object = system.object(id);
  return object == nullptr ? "" : object->name;
}

std::string ServiceAt(const System& system, const OServiceEntry& entry) {
  const Object* const object = system.object(ObjectIdOf(entry.GetOID()));
  return object == nullptr ? "" : ServiceOfEntry(*object, entry.GetSelector());
}

bool NamesEnd(const std::string& wanted, const std::string& end) {
  if (wanted.empty()) return true;
  if (wanted.find('.') != std::string::npos) return NamesService(wanted, end);
  return end.substr(0, end.find('.')) == wanted;
}

std::string CheckEnd(const System& system, const std::string& name) {
  if (name.empty()) return "";
  std::vector<std::string> known;
  const bool is_service = name.find('.') != std::string::npos;
  if (is_service) {
    for (const auto& [service, entry] : system.robot(0).directory) {
      if (NamesService(name, service)) return "";
      known.push_back(service);
    }
  } else {
    for (const auto& object : system.objects()) known.push_back(object->name);
    if (std::find(known.begin(), known.end(), name) != known.end()) return "";
  }
  return fmt::format("there is no {} '{}'{}", is_service ? "service" : "object", name,
                     DidYouMean(name, known));
}

}  // namespace

DeliveredMessage Describe(const System& system, const TraceRecord& record, const Message& message) {
  DeliveredMessage seen;
  seen.number = record.number;
  seen.cause = record.cause;
  seen.time_us = record.time_us;
  seen.kind = KindOf(message);
  seen.from = NameOf(system, message.sender);
  seen.to = NameOf(system, message.target);
  seen.target = record.target;
  seen.selector = record.selector;
  const Object* const target = system.object(message.target);
  if (target != nullptr && !message.is_reply) seen.entry = target->EntryName(message.selector);
  if (message.kind == PayloadKind::kNotify) {
    seen.from =
        ServiceAt(system, reinterpret_cast<const ONotifyMessage*>(message.payload)->subjectID);
  } else if (message.kind == PayloadKind::kReady) {
    seen.from =
        ServiceAt(system, reinterpret_cast<const OReadyMessage*>(message.payload)->observerID);
  }
  if (message.kind == PayloadKind::kNotify || message.kind == PayloadKind::kReady) {
    if (target != nullptr) seen.to = ServiceOfEntry(*target, message.selector);
  }
  return seen;
}

std::string MessageFilter::Check(const System& system) const {
  const bool is_kind =
      kind.empty() || std::find(std::begin(kKinds), std::end(kKinds), kind) != std::end(kKinds);
  if (!is_kind)
    return fmt::format("'{}' is no kind of message; kinds are {}", kind, fmt::join(kKinds, ", "));
  std::string problem = CheckEnd(system, from);
  return problem.empty() ? CheckEnd(system, to) : problem;
}

bool MessageFilter::Fits(const DeliveredMessage& message) const {
  if (!kind.empty() && kind != message.kind) return false;
  if (!entry.empty() && entry != message.entry) return false;
  return NamesEnd(from, message.from) && NamesEnd(to, message.to);
}

std::string MessageFilter::Text() const {
  return fmt::format("{} {} -> {}{}", kind.empty() ? "message" : kind,
                     from.empty() ? "(any)" : from, to.empty() ? "(any)" : to,
                     entry.empty() ? "" : ", entry " + entry);
}

}  // namespace openr_host
