#include "runtime/core/code_object.h"

#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/system.h"

namespace openr_host {

CodeObject::CodeObject() : host_(t_current.object) {
  ASSERT(host_ != nullptr, "objects built in code are made with System::AddObject()");
}

CodeObject::~CodeObject() = default;

OSubject* CodeObject::AddSubject(const std::string& service, Ready ready) {
  const int index = static_cast<int>(own_subjects_.size());
  OSubject* const subject = own_subjects_.emplace_back(std::make_unique<OSubject>()).get();
  const Selector control = AddExtra(service + " (Control)", [subject](void* message) {
    subject->ControlHandler(*static_cast<OControlMessage*>(message));
  });
  const Selector entry = AddExtra(service + " (Ready)", [subject, index, ready](void* message) {
    const auto& msg = *static_cast<OReadyMessage*>(message);
    subject->ReadyHandler(msg);
    if (ready) ready(OReadyEvent(index, msg.observerID, msg.command));
  });
  subject->SetReadyEntry(OServiceEntry(myOID_, entry));
  RegisterServiceEntry(OServiceEntry(myOID_, control), service.c_str());
  return subject;
}

OObserver* CodeObject::AddObserver(const std::string& service, Notify notify) {
  const int index = static_cast<int>(own_observers_.size());
  OObserver* const observer = own_observers_.emplace_back(std::make_unique<OObserver>()).get();
  const Selector connect = AddExtra(service + " (Connect)", [observer](void* message) {
    observer->ConnectHandler(*static_cast<OConnectMessage*>(message));
  });
  const Selector entry = AddExtra(service + " (Notify)", [observer, index, notify](void* message) {
    ONotifyEvent event;
    event.SetIndex(index);
    observer->NotifyHandler(*static_cast<ONotifyMessage*>(message), &event);
    if (notify) notify(event);
  });
  observer->SetNotifyEntry(OServiceEntry(myOID_, entry));
  RegisterServiceEntry(OServiceEntry(myOID_, connect), service.c_str());
  return observer;
}

Selector CodeObject::AddExtra(const std::string& name, Extra extra) {
  entries_.push_back(std::move(extra));
  const Selector selector = oentryBASE + static_cast<Selector>(entries_.size()) - 1;
  host_->entry_names[selector] = name;
  return selector;
}

CodeHost::~CodeHost() {
  const CurrentScope scope(system, this);
  code.reset();
}

bool CodeHost::HasEntry(uint32_t selector) const {
  return code != nullptr && selector < oentryBASE + code->entries_.size();
}

bool CodeHost::Dispatch(uint32_t selector, void* payload) {
  if (!HasEntry(selector)) return false;
  if (selector >= oentryBASE) {
    code->entries_[selector - oentryBASE](payload);
    return true;
  }
  auto& message = *static_cast<OReasonMessage*>(payload);
  const OSystemEvent event(message.reason, message.param, message.paramSize);
  switch (selector) {
    case oentryINIT:
      code->Init(event);
      break;
    case oentrySTART:
      code->Start(event);
      break;
    case oentrySTOP:
      code->Stop(event);
      break;
    default:
      code->Destroy(event);
      break;
  }
  return true;
}

void CodeHost::HashState(Hasher* hasher) const { code->HashState(hasher); }

}  // namespace openr_host
