// OSubject, the sending end of connections.  The runtime keeps the state of each OSubject in a
// SubjectState, which has an ObserverLink for each observer (subject_state.h).
#include <OPENR/OSubject.h>

#include <algorithm>
#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_messages.h"
#include "runtime/core/region_access.h"
#include "runtime/core/requests.h"
#include "runtime/core/subject_state.h"
#include "runtime/core/system.h"

using namespace openr_host;

namespace {

// Makes an RCRegion (a counted reference) for `size` bytes at `offset` of the region `memory`, and
// calls `set` with the RCRegion.  A program has made this shared memory with
// NewSharedMemoryRegion() or a similar function.  The bytes are not copied.  Returns oINVALID_ARG
// if the region does not exist or the bytes do not lie in the region.
template <typename Set>
OStatus WithRegion(MemoryRegionID memory, size_t offset, size_t size, Set set) {
  const ApiScope scope;
  if (t_current.system == nullptr) return oFAIL;
  const RegionTable& table = t_current.system->regions();
  const size_t whole = table.SizeOf(memory);
  // Refuses a part of a region that does not lie inside the region.  Compares `size` with a
  // difference, because the sum offset + size could overflow.
  if (table.BaseOf(memory) == nullptr || size == 0 || offset > whole || size > whole - offset) {
    return oINVALID_ARG;
  }
  RCRegion* const region = new RCRegion(memory, static_cast<offset_t>(offset), nullptr, size);
  const OStatus status = set(region);
  region->RemoveReference();
  return status;
}

// Calls `set` with a new RCRegion that has a copy of the `size` bytes at `bytes`.  Returns
// oNO_MEMORY if there is no memory for the copy.
template <typename Set>
OStatus WithCopyOf(const void* bytes, size_t size, Set set) {
  RCRegion* const region = new RCRegion(size);
  OStatus status = oNO_MEMORY;
  if (region->Base() != nullptr) {
    std::memcpy(region->Base(), bytes, size);
    status = set(region);
  }
  // Gives back the reference that the constructor of RCRegion took.  Each ObserverLink (the
  // subject's record of one observer) that got the data holds a reference of its own by now.  So
  // the region lives until the last observer has given it back.
  region->RemoveReference();
  return status;
}

// Returns the number of bytes from the byte that `locator` names to the end of its region, or 0 if
// the region does not exist.
size_t SizeFrom(const OMemoryLocator& locator) {
  const ApiScope scope;
  if (t_current.system == nullptr) return 0;
  const size_t whole = t_current.system->regions().SizeOf(locator.mid);
  return whole > locator.offset ? whole - locator.offset : 0;
}

}  // namespace

OSubject::OSubject() {
  const ApiScope scope;
  ASSERT(t_current.object != nullptr, "an OSubject is made by the code of an object");
  state_ = t_current.object->AddSubject(
      std::make_unique<SubjectState>(t_current.system, t_current.object));
}

// Deletes nothing, because the openr_host::Object owns *state_ and deletes it.
OSubject::~OSubject() = default;

OStatus OSubject::SetReadyEntry(const OServiceEntry& entry) {
  const ApiScope scope;
  state_->id = ENTRY2SUBJECTID(entry);
  return oSUCCESS;
}

const SubjectID& OSubject::GetID() const { return state_->id; }

OStatus OSubject::SetBufferSize(size_t size) {
  state_->buffer_size = size;
  return oSUCCESS;
}

size_t OSubject::GetBufferSize() const { return state_->buffer_size; }

OStatus OSubject::SetNotifyUnitSize(size_t size) {
  const ApiScope scope;
  if (!state_->links.empty()) {
    state_->system->AddFinding(Severity::kWarning,
                               "SetNotifyUnitSize() after a connection is refused; "
                               "call it in DoInit");
    return oFAIL;
  }
  state_->unit_size = size;
  return oSUCCESS;
}

size_t OSubject::GetNotifyUnitSize() const { return state_->unit_size; }

OStatus OSubject::SetData(const void* buf, size_t size) {
  const ApiScope scope;
  // Makes no region if there are no observers, because nobody would take a reference to the region
  // and it would be deleted at once.
  if (state_->links.empty()) return oSUCCESS;
  return WithCopyOf(buf, size, [this](RCRegion* region) { return SetData(region); });
}

OStatus OSubject::SetData(RCRegion* region) {
  if (region == nullptr) return oINVALID_ARG;
  return InApi([state = state_, region] {
    OStatus status = oSUCCESS;
    // If SetData() fails for one observer, goes on with the next observer, so that all other
    // observers get the data.  Returns the status of the last failure.
    for (ObserverLink& link : state->links) {
      const OStatus one = state->SetData(&link, region);
      if (one != oSUCCESS) status = one;
    }
    return status;
  });
}

OStatus OSubject::SetData(const OShmPtrBase& ptr) { return SetData(ptr.RCRPtr()); }

OStatus OSubject::SetData(const ObserverID& id, const void* buf, size_t size) {
  const ApiScope scope;
  return WithCopyOf(buf, size, [&](RCRegion* region) { return SetData(id, region); });
}

OStatus OSubject::SetData(const ObserverID& id, RCRegion* region) {
  const ApiScope scope;
  ObserverLink* const link = state_->Find(id);
  return link == nullptr || region == nullptr ? oINVALID_ARG : state_->SetData(link, region);
}

OStatus OSubject::SetData(const ObserverID& id, const OShmPtrBase& ptr) {
  return SetData(id, ptr.RCRPtr());
}

OStatus OSubject::SetData(const OObserverInfo& info, const void* buf, size_t size) {
  return SetData(info.GetObserverID(), buf, size);
}

OStatus OSubject::SetData(const OObserverInfo& info, RCRegion* region) {
  return SetData(info.GetObserverID(), region);
}

OStatus OSubject::SetData(const OObserverInfo& info, const OShmPtrBase& ptr) {
  return SetData(info.GetObserverID(), ptr.RCRPtr());
}

OStatus OSubject::SetData(MemoryRegionID memory, size_t size) {
  return WithRegion(memory, 0, size, [this](RCRegion* region) { return SetData(region); });
}

OStatus OSubject::SetData(const OMemoryLocator& locator) {
  return WithRegion(locator.mid, locator.offset, SizeFrom(locator),
                    [this](RCRegion* region) { return SetData(region); });
}

OStatus OSubject::SetData(const ObserverID& id, MemoryRegionID memory, u_int size) {
  return WithRegion(memory, 0, size, [this, &id](RCRegion* region) { return SetData(id, region); });
}

OStatus OSubject::SetData(const ObserverID& id, const OMemoryLocator& locator) {
  return WithRegion(locator.mid, locator.offset, SizeFrom(locator),
                    [this, &id](RCRegion* region) { return SetData(id, region); });
}

OStatus OSubject::NotifyObservers() {
  return InApi([state = state_] {
    for (ObserverLink& link : state->links) state->Notify(&link);
    return oSUCCESS;
  });
}

OStatus OSubject::NotifyObserver(const OObserverInfo& info) {
  return NotifyObserver(info.GetObserverID());
}

OStatus OSubject::NotifyObserver(const ObserverID& id) {
  const ApiScope scope;
  ObserverLink* const link = state_->Find(id);
  return link == nullptr ? oINVALID_ARG : state_->Notify(link);
}

namespace {

// Returns how many more calls of SetData() for the observer of `link` fit into the subject's
// buffer.
size_t Remain(const SubjectState& state, const ObserverLink& link) {
  const size_t used = link.fresh.size() + link.pending.size();
  // Subtracts 1 from the size of the subject's buffer, because the robot's buffer is a ring buffer
  // in which one place always stays empty.
  const size_t room = std::max<size_t>(state.buffer_size, 1) - 1;
  return room - std::min(used, room);
}

}  // namespace

size_t OSubject::RemainBuffer() const {
  size_t remain = std::max<size_t>(state_->buffer_size, 1) - 1;
  for (const ObserverLink& link : state_->links) remain = std::min(remain, Remain(*state_, link));
  return remain;
}

size_t OSubject::RemainBuffer(const OObserverInfo& info) const {
  return RemainBuffer(info.GetObserverID());
}

size_t OSubject::RemainBuffer(const ObserverID& id) const {
  const ObserverLink* const link = state_->Find(id);
  return link == nullptr ? 0 : Remain(*state_, *link);
}

OStatus OSubject::ClearBuffer() {
  const ApiScope scope;
  for (ObserverLink& link : state_->links) state_->Clear(&link);
  return oSUCCESS;
}

OStatus OSubject::ClearBuffer(const OObserverInfo& info) {
  return ClearBuffer(info.GetObserverID());
}

OStatus OSubject::ClearBuffer(const ObserverID& id) {
  const ApiScope scope;
  ObserverLink* const link = state_->Find(id);
  if (link == nullptr) return oINVALID_ARG;
  state_->Clear(link);
  return oSUCCESS;
}

OStatus OSubject::ControlHandler(const OControlMessage& msg, OStatus status) {
  const ApiScope scope;
  System* const system = state_->system;
  // Stores the name of the service, by which findings name this subject, because the name cannot
  // be found any more when this Control entry has returned.
  state_->service = state_->object->NameService(state_->id.GetSelector(), "Ready");
  switch (msg.command) {
    case objcommCMD_ADDOBSERVER:
    case objcommCMD_ADDOBSERVER_SELF:
    case objcommCMD_ADDOBSERVER_V22: {
      // Adds no ObserverLink (the subject's record of one observer) if the program has refused the
      // observer, or if there is one for this observer already.  The reply has the program's
      // status.
      if (status != oSUCCESS || state_->Find(msg.observerID) != nullptr) break;
      ObserverLink& link = state_->links.emplace_back();
      link.observer = msg.observerID;
      link.target = ObjectIdOf(msg.observerID.GetOID());
      const openr_host::Object* const peer = system->object(link.target);
      link.name = peer == nullptr ? "an unknown object" : peer->name;
      link.skip = msg.d_skip;
      link.min = std::max<size_t>(msg.d_min, 1);
      link.max = std::max<size_t>(msg.d_max, link.min);
      state_->infos.push_back(OObserverInfo(msg.observerID));
      break;
    }
    case objcommCMD_REMOVEOBSERVER:
    case objcommCMD_REMOVEOBSERVER_SELF:
    case objcommCMD_REMOVEOBSERVER_V22: {
      ObserverLink* const link = state_->Find(msg.observerID);
      if (link == nullptr) break;
      // Drops the data that the subject keeps for this observer, because the observer is removed
      // and will not receive them any more.
      state_->Clear(link);
      std::erase_if(state_->links,
                    [&](const ObserverLink& each) { return each.observer == msg.observerID; });
      state_->infos.remove_if(
          [&](const OObserverInfo& info) { return info.GetObserverID() == msg.observerID; });
      break;
    }
    default:
      status = oUNKNOWN_COMMAND;
  }
  OControlReplyMessage reply;
  // Clears the padding too, because the trace hashes all bytes of this reply.
  std::memset(static_cast<void*>(&reply), 0, sizeof reply);
  reply.msgType = omsgCONTROL_REPLY_V21;
  reply.status = status;
  reply.subjectID = state_->id;
  ReplyToRequest(&reply, sizeof reply);
  return status;
}

namespace {

// Does the work of OSubject::ReadyHandler() for the subject of `state`.
[[gnu::always_inline]] inline OStatus HandleReady(SubjectState* state, const OReadyMessage& msg) {
  // Refuses a message whose bytes are no ready, because this function uses some bytes of a ready as
  // addresses of regions.
  if (!IsRunningMessage(*state->object, PayloadKind::kReady)) return oUNKNOWN_COMMAND;
  // A ready also lists the regions of earlier notifications that the observer no longer uses.
  // Removes the subject's reference to each of these regions, so that the subject can write into
  // them again.
  for (int i = 0; i < msg.numOfData; ++i) RegionAccess::RemoveReference(msg.rcRegion[i]);
  ObserverLink* const link = state->Find(msg.observerID);
  // Returns an error if the subject has removed the observer since the observer sent this ready.
  // This check comes after the release of the regions, because a removed observer gives its regions
  // back, too.
  if (link == nullptr) return oNOT_FOUND;
  if (msg.command == objcommCMD_DEASSERT_READY) {
    link->ready = -1;
    link->is_lost = msg.msgType == openr_host::kDeassertOfLost;
    return oSUCCESS;
  }
  if (msg.command != objcommCMD_ASSERT_READY) return oUNKNOWN_COMMAND;
  link->ready = 1;
  // Sends the notifications that wait for this ready now, before the program's Ready function runs,
  // as Sony's library does (measured.md 1.9).
  state->Flush(link);
  return oSUCCESS;
}

}  // namespace

OStatus OSubject::ReadyHandler(const OReadyMessage& msg) {
  return InApi([state = state_, &msg] { return HandleReady(state, msg); });
}

int OSubject::NumberOfObservers() const { return static_cast<int>(state_->links.size()); }
ObserverConstIterator OSubject::begin() const { return state_->infos.begin(); }
ObserverConstIterator OSubject::end() const { return state_->infos.end(); }

ObserverConstIterator OSubject::FindObserver(const ObserverID& id) const {
  return std::find_if(begin(), end(),
                      [&](const OObserverInfo& info) { return info.GetObserverID() == id; });
}

int OSubject::IsAnyReady() const {
  // Counts all ready observers and does not stop at the first, because Sony's library returns their
  // number (measured.md 1.16).
  int count = 0;
  for (const ObserverLink& link : state_->links) count += link.ready > 0;
  return count;
}

int OSubject::IsAllReady() const {
  for (const ObserverLink& link : state_->links) {
    // If link.ready is 0, the observer has not asserted ready since the last notification, so not
    // all observers are ready.  If link.ready is -1, the observer has deasserted ready.  It wants
    // no data, so it is left out here (core.md 2.2).
    if (link.ready == 0) return 0;
  }
  return IsAnyReady();
}

int OSubject::IsReady(const ObserverID& id) const {
  const ObserverLink* const link = state_->Find(id);
  return link != nullptr && link->ready > 0;
}

int OSubject::ReadyStatus(const ObserverID& id) const {
  const ObserverLink* const link = state_->Find(id);
  return link == nullptr ? 0 : link->ready;
}
