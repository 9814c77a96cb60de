#include "runtime/core/code_object.h"

#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/current.h"
#include "runtime/core/observer_state.h"
#include "runtime/core/subject_state.h"

namespace openr_host {

CodeObject::CodeObject() : host_(t_current.object) {
  ASSERT(host_ != nullptr, "objects built in code are made with System::AddObject()");
}

// Clears the Object's pointer to the table of entries, because this table ends with the CodeObject.
// This destructor runs also if the constructor of a derived class throws an exception.
CodeObject::~CodeObject() { host_->set_code_entries(nullptr); }

void CodeObject::AddSubjectEntries(const std::string& service, OSubject* subject,
                                   std::unique_ptr<CodeEntry> entry) {
  const Selector control = AddExtra(service + " (Control)", [subject](void* message) {
    subject->ControlHandler(*static_cast<OControlMessage*>(message));
  });
  // The last element of host_->subjects() is the SubjectState of `subject`, because the caller has
  // made `subject` immediately before this call.
  ASSERT(!host_->subjects().empty(), "{} has no subject", service);
  entry->subject_state = host_->subjects().back().get();
  const Selector ready = AddEntry(service + " (Ready)", std::move(entry));
  subject->SetReadyEntry(OServiceEntry(myOID_, ready));
  RegisterServiceEntry(OServiceEntry(myOID_, control), service.c_str());
}

void CodeObject::AddObserverEntries(const std::string& service, OObserver* observer,
                                    std::unique_ptr<CodeEntry> entry) {
  const Selector connect = AddExtra(service + " (Connect)", [observer](void* message) {
    observer->ConnectHandler(*static_cast<OConnectMessage*>(message));
  });
  ASSERT(!host_->observers().empty(), "{} has no observer", service);
  entry->observer_state = host_->observers().back().get();
  const Selector notify = AddEntry(service + " (Notify)", std::move(entry));
  observer->SetNotifyEntry(OServiceEntry(myOID_, notify));
  RegisterServiceEntry(OServiceEntry(myOID_, connect), service.c_str());
}

Selector CodeObject::AddEntry(const std::string& name, std::unique_ptr<CodeEntry> entry) {
  entries_.push_back(std::move(entry));
  host_->set_code_entries(entries_.data());
  const Selector selector = oentryBASE + static_cast<Selector>(entries_.size()) - 1;
  host_->entry_names().SetName(selector, name);
  return selector;
}

CodeHost::~CodeHost() {
  // Makes this object the current object, because destructors of its code may call functions of the
  // SDK.
  const CurrentScope scope(system, this);
  set_entry_count(0);
  code.reset();
}

void CodeHost::SetCode(std::unique_ptr<CodeObject> made) {
  code = std::move(made);
  set_entry_count(oentryBASE + static_cast<uint32_t>(code->entries_.size()));
}

bool CodeHost::HasEntry(uint32_t selector) const {
  return code != nullptr && selector < oentryBASE + code->entries_.size();
}

bool CodeHost::Dispatch(uint32_t selector, void* payload) {
  if (selector >= entry_count() && !HasEntry(selector)) return false;
  if (selector < oentryBASE) [[unlikely]] {
    CallSystemEntry(selector, payload);
  } else {
    code_entries()[selector - oentryBASE]->Handle(payload);
  }
  return true;
}

// Calls DoInit, DoStart, DoStop or DoDestroy of the CodeObject (an object that is a C++ class of
// this program), as `selector` demands.
void CodeHost::CallSystemEntry(uint32_t selector, void* payload) {
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
}

void CodeHost::HashState(Hasher* hasher) const { code->HashState(hasher); }

}  // namespace openr_host
