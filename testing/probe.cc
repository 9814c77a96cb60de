#include "testing/probe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "runtime/config/service_name.h"
#include "runtime/core/api.h"
#include "runtime/core/post_as_object.h"
#include "runtime/core/system.h"
#include "testing/message_spec.h"

namespace openr::testing {

using openr_host::CurrentScope;
using openr_host::Object;
using openr_host::System;

namespace {

// Returns the name, such as "Blinker.Blink", of the service with the Ready or Notify handler
// `entry`.
std::string NameOf(const System& system, const OServiceEntry& entry) {
  const Object* const object = system.object(openr_host::ObjectIdOf(entry.GetOID()));
  if (object == nullptr) return "(unknown)";
  const std::string name = object->EntryName(entry.GetSelector());
  return ShortName({object->name, std::string_view(name).substr(0, name.find(" ("))});
}

// Returns the subject or observer in the list `ends` that has the name `name`.  `name` may leave
// out the object and the last parts of the full name.
template <typename End>
End& FindEnd(std::deque<End>& ends, const Object& object, std::string_view name, const char* kind) {
  std::vector<std::string> known;
  for (End& end : ends) {
    const std::string& service = end.service();
    const std::string_view without_object = std::string_view(service).substr(service.find('.') + 1);
    if (openr_host::NamesService(name, service) || openr_host::NamesService(name, without_object))
      return end;
    known.push_back(service);
  }
  throw std::invalid_argument(fmt::format("probe {} has no {} '{}'; it has: {}", object.name, kind,
                                          name, fmt::join(known, ", ")));
}

}  // namespace

bool ReceivedEvent::CheckSize(size_t i, size_t size, const Place& place) const {
  if (i < data.size() && data[i].size() == size) return true;
  Fail(place,
       i < data.size()
           ? fmt::format("Message #{} of {}: datum {} has {} bytes, the type asked for has {}",
                         number, from, i, data[i].size(), size)
           : fmt::format("Message #{} of {} has {} data, number {} was asked for", number, from,
                         data.size(), i));
  return false;
}

std::string ReceivedEvent::text(size_t i, Place place) const {
  if (i >= data.size()) {
    CheckSize(i, 0, place);
    return "";
  }
  return data[i].substr(0, data[i].find('\0'));
}

bool ProbeObserver::CheckAny(const Place& place) const {
  if (!events_.empty() && !events_.back().data.empty()) return true;
  Fail(place, service_ + " has received nothing");
  return false;
}

OStatus ProbeObserver::AssertReady() {
  const CurrentScope scope(&probe_->system(), &probe_->host());
  return end_->AssertReady();
}

OStatus ProbeObserver::DeassertReady() {
  const CurrentScope scope(&probe_->system(), &probe_->host());
  return end_->DeassertReady();
}

OStatus ProbeSubject::SetBytes(const void* bytes, size_t size, Place place) {
  const CurrentScope scope(&probe_->system(), &probe_->host());
  if (end_->NumberOfObservers() == 0) {
    Fail(place, fmt::format("Nobody is connected to {}, so nobody hears it: bench.Wire(\"{}\", "
                            "\"...O\") before bench.Boot()",
                            service_, service_));
  }
  return end_->SetData(bytes, size);
}

OStatus ProbeSubject::Notify() {
  const CurrentScope scope(&probe_->system(), &probe_->host());
  return end_->NotifyObservers();
}

OStatus ProbeSubject::SendText(const std::string& text, Place place) {
  SetBytes(text.c_str(), text.size() + 1, place);
  return Notify();
}

Probe::Probe(const std::vector<std::string>& services) {
  for (const std::string& service : services)
    service.ends_with(".S") ? AddSubjectEnd(service) : AddObserverEnd(service);
}

void Probe::CheckServices(const std::vector<std::string>& services) {
  for (const std::string& service : services) {
    openr_host::ServiceNameFault fault;
    if (openr_host::ParseServiceName(service, &fault)) continue;
    throw std::invalid_argument(
        fmt::format("'{}' is no service: {}; services are \"Object.Service.Type.S\" (a subject) "
                    "and \"Object.Service.Type.O\" (an observer)",
                    service, fault.message));
  }
}

void Probe::AddSubjectEnd(const std::string& service) {
  ProbeSubject* const subject = &subjects_.emplace_back();
  subject->service_ = service;
  subject->probe_ = this;
  subject->end_ = AddSubject(service, [this, subject](const OReadyEvent& event) {
    subject->readies_.push_back(
        {system().now_us(), NameOf(system(), event.SenderID()), event.IsAssert() != 0});
    if (subject->on_ready_) subject->on_ready_(event);
  });
}

void Probe::AddObserverEnd(const std::string& service) {
  ProbeObserver* const observer = &observers_.emplace_back();
  observer->service_ = service;
  observer->probe_ = this;
  observer->end_ =
      AddObserver(service, [this, observer](const ONotifyEvent& event) { Hear(observer, event); });
}

void Probe::Hear(ProbeObserver* observer, const ONotifyEvent& event) {
  ReceivedEvent received;
  received.time_us = system().now_us();
  received.number = host().running()->number;
  received.from = NameOf(system(), event.SenderID().GetSubjectID());
  received.notify_count = event.NumOfNotify();
  for (int i = 0; i < event.NumOfData(); ++i) {
    const RCRegion* const region = event.RCData(i);
    received.data.emplace_back(region->Base(), region->Size());
  }
  observer->events_.push_back(std::move(received));
  if (observer->on_event_) observer->on_event_(event);
  if (observer->auto_ready_) observer->end_->AssertReady(event.SenderID().GetSubjectID());
}

ProbeSubject& Probe::subject(std::string_view service) {
  return FindEnd(subjects_, host(), service, "subject");
}

ProbeObserver& Probe::observer(std::string_view service) {
  return FindEnd(observers_, host(), service, "observer");
}

OStatus Probe::DoInit(const OSystemEvent&) {
  calls_.push_back("DoInit");
  return oSUCCESS;
}

OStatus Probe::DoStart(const OSystemEvent&) {
  calls_.push_back("DoStart");
  if (on_start_) on_start_();
  for (ProbeObserver& observer : observers_) {
    if (observer.auto_ready_) observer.end_->AssertReady();
  }
  return oSUCCESS;
}

OStatus Probe::DoStop(const OSystemEvent&) {
  calls_.push_back("DoStop");
  return oSUCCESS;
}

OStatus Probe::DoDestroy(const OSystemEvent&) {
  calls_.push_back("DoDestroy");
  return oSUCCESS;
}

}  // namespace openr::testing
