#include "distribution/remote_resources.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "distribution/remote_object.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_messages.h"
#include "runtime/core/system.h"

namespace openr_host {

void RemoteResources::Begin(System* system) {
  system_ = system;
  if (marshaller_ != nullptr) return;
  marshaller_ = std::make_unique<Marshaller>(system, false);
  calls_ = std::make_unique<CheckedCalls>(
      system, [this](ObjectId id) { return objects_.contains(id); },
      [this](const std::string& what) { connection_->Refuse(what); });
}

void RemoteResources::Add(RemoteObject* object) {
  objects_[object->id] = object;
  object->set_lost(connection_->is_lost());
}

void RemoteResources::SetLost(bool is_lost) const {
  for (const auto& [id, object] : objects_) object->set_lost(is_lost);
}

RemoteObject* RemoteResources::ObjectOf(ObjectId id) const {
  const auto found = objects_.find(id);
  if (found == objects_.end()) connection_->Refuse("a request of an object that is not its own");
  return found->second;
}

bool RemoteResources::MayUse(uint32_t region) const {
  return calls_->HasRegion(region) || marshaller_->HasExported(region);
}

uint64_t RemoteResources::HeapOfOtherProcesses(System* system, int robot) const {
  const auto heap = heap_by_robot_.find(robot);
  return system->robot(robot).memory.used_bytes - (heap == heap_by_robot_.end() ? 0 : heap->second);
}

void RemoteResources::RecordHeap(int robot, uint64_t bytes) {
  // Largest number of heap bytes that a worker may report for the objects on one robot.  Without
  // --strict, objects may use more than the 32 MB of a robot.  So the limit is much larger, and
  // only a faulty worker exceeds it.
  constexpr uint64_t kHeapMaxBytes = uint64_t{1} << 40;
  if (bytes > kHeapMaxBytes) connection_->Refuse("a heap that is too large");
  system_->robot(robot).memory.used_bytes += bytes - std::exchange(heap_by_robot_[robot], bytes);
}

void RemoteResources::RecordDropped(RemoteObject* object, uint64_t count) {
  object->statistics().NoteDropped(count - std::exchange(dropped_[object->id], count));
}

void RemoteResources::HandleUndelivered(const Message& message) {
  if (marshaller_ != nullptr) marshaller_->CompleteSend(message);
}

void RemoteResources::Wake(ObjectId object, uint64_t box) {
  OwnedMessage wake = system_->NewMessage(object, 0);
  wake->message_class = MessageClass::kInput;
  wake->is_reply = true;
  wake->reply_box = box;
  system_->Post(std::move(wake));
}

void RemoteResources::ReleaseAll() {
  ReleaseExported();
  marshaller_->PeerIsLost();
  for (const auto& [id, object] : objects_) {
    // Ends the wait of a RemoteObject, the master's stand-in for an object of the worker, if its
    // handler in the worker had not returned.  The lost worker will never report the end of this
    // handler.
    if (object->delivery().blocked() != nullptr) Wake(id, object->wait().box());
  }
  calls_->ReleasePins();
  // Removes the lost process's counts of lost data and messages and its heap use, because the next
  // process counts from 0.
  dropped_.clear();
  for (const auto& [robot, bytes] : std::exchange(heap_by_robot_, {}))
    system_->robot(robot).memory.used_bytes -= bytes;
}

// Gives the regions that were sent to the lost worker back to the subjects that sent them.  The
// worker's observers cannot do this any more.  So the master sends deasserts ("not ready"), which
// give the regions back, in the name of these observers.
void RemoteResources::ReleaseExported() {
  using Entry = std::pair<ObjectId, uint32_t>;
  // The regions to give back, grouped by observer and subject.  A deassert ("not ready") goes from
  // one observer to one subject, so the regions of one group go back with one deassert.
  std::map<std::pair<Entry, Entry>, std::vector<RCRegion*>> regions;
  for (const Marshaller::ExportedRegion& exported : marshaller_->TakeExported())
    regions[{{exported.observer, exported.observer_selector},
             {exported.subject, exported.subject_selector}}]
        .push_back(exported.region);
  for (const auto& [ends, exported] : regions) {
    const auto& [observer, subject] = ends;
    const auto found = objects_.find(observer.first);
    if (found == objects_.end()) continue;
    // Sends several deasserts if necessary, because one deassert gives back MAX_NUM_DATA regions at
    // most.
    for (size_t i = 0; i < exported.size(); i += MAX_NUM_DATA) {
      const auto begin = exported.begin() + static_cast<ptrdiff_t>(i);
      const auto count = std::min<ptrdiff_t>(MAX_NUM_DATA, exported.end() - begin);
      SendDeassert(found->second, observer.second,
                   OServiceEntry(OidOf(subject.first), subject.second), {begin, begin + count});
    }
  }
}

}  // namespace openr_host
