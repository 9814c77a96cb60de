#include "distribution/remote_loader.h"

#include <string>

#include "distribution/remote_object.h"

namespace openr_host {

void RemoteLoader::Welcome(System* system, const openr_wire_Welcome& welcome) {
  resources_->Begin(system);
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_WELCOME);
  to_worker.body._u.welcome = welcome;
  connection_->Send(to_worker);
}

void RemoteLoader::BeginLoad(const openr_wire_Load& load) {
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_LOAD);
  to_worker.body._u.load = load;
  awaited_objects_.clear();
  for (uint32_t i = 0; i < load.objects._length; ++i) {
    if (load.objects._buffer[i].is_own) awaited_objects_.insert(load.objects._buffer[i].id);
  }
  connection_->Send(to_worker);
}

void RemoteLoader::Load(const openr_wire_Load& load) {
  BeginLoad(load);
  while (!HandleSample(*connection_->Next(), resources_->objects())) {
  }
}

bool RemoteLoader::HasLoaded(const std::map<ObjectId, RemoteObject*>& objects) {
  while (const RemoteConnection::ReceivedSample to_master = connection_->channel()->Receive(0)) {
    if (HandleSample(*to_master, objects)) return true;
  }
  const std::string problem = connection_->FindProblem();
  if (!problem.empty()) throw ProcessLost(problem);
  return false;
}

// Handles a sample of a worker that loads its objects.  Returns true when the worker has loaded
// them.  `objects` are the stand-ins for these objects.
bool RemoteLoader::HandleSample(const openr_wire_ToMaster& to_master,
                                const std::map<ObjectId, RemoteObject*>& objects) {
  connection_->CheckGoodbye(to_master);
  if (effects_->HandleRequest(to_master)) return false;
  if (to_master.body._d != openr_wire_TO_MASTER_LOADED)
    connection_->Refuse("no list of its objects");
  const auto& loaded = to_master.body._u.loaded.objects;
  std::string problem;
  RemoteObject* object = nullptr;
  for (uint32_t i = 0; i < loaded._length; ++i) {
    const openr_wire_LoadedObject& entry = loaded._buffer[i];
    const auto found = objects.find(entry.id);
    if (found == objects.end() || awaited_objects_.erase(entry.id) == 0)
      connection_->Refuse("an object that is not its own, or sent it twice");
    object = found->second;
    if (entry.problem != nullptr && *entry.problem != '\0') {
      if (problem.empty()) problem = entry.problem;
      continue;
    }
    object->SetDescription(entry);
    resources_->RecordHeap(object->robot, entry.heap_here);
  }
  // Applies the effects only after the object has its entries and priority, because constructors
  // may have sent messages to their own object.
  effects_->ApplyLoaded(to_master, object);
  if (!problem.empty()) throw ProcessLost(problem);
  if (!awaited_objects_.empty()) connection_->Refuse("nothing of an object that it was to load");
  return true;
}

}  // namespace openr_host
