// Implements the functions of Worker that load a run: they add its robots and objects to the tables
// of this process, find its Memory Stick, and count the heap that its objects use.
#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "distribution/remote_services.h"
#include "distribution/worker.h"
#include "runtime/core/load_image.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/ipstack/loopback_network.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

bool IsFolder(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_directory(path, error);
}

// Represents an object of another process in the tables of this process.  An AbsentObject runs no
// handler, because messages to it go to the master.
class AbsentObject : public Object {
 public:
  AbsentObject(System* system, ObjectId id, int robot, Marshaller* marshaller)
      : Object(system, id, robot), marshaller_(marshaller) {}
  bool HasEntry(uint32_t) const override { return true; }
  bool Dispatch(uint32_t, void*) override { return false; }
  void ReturnRegion(RCRegion* region) override { marshaller_->ReleaseImported(region); }

 private:
  Marshaller* const marshaller_;
};

}  // namespace

std::string Worker::LoadObjects(const openr_wire_Load& load) {
  for (uint32_t i = 0; i < load.robots._length; ++i) {
    const std::string problem = AddRobot(load.robots._buffer[i]);
    if (!problem.empty()) return problem;
  }
  for (uint32_t i = 0; i < load.heap_elsewhere._length; ++i) {
    CheckRobot(static_cast<int>(i));
    SetHeapOfOtherProcesses(static_cast<int>(i), load.heap_elsewhere._buffer[i]);
  }
  if (!std::exchange(has_checked_stick_, true)) {
    const std::string problem =
        options_.find_stick_problem ? options_.find_stick_problem(stick_) : "";
    is_refused_ = !problem.empty();
    if (is_refused_) return problem;
    if (options_.before_loading) options_.before_loading(stick_);
  }
  // Sets the clock, because constructors may read it.  It is not 0 when the worker was restarted.
  if (load.now_us > system_->now_us()) system_->RunUntil(load.now_us);
  for (uint32_t i = 0; i < load.designs._length; ++i) {
    const openr_wire_DesignEntry& entry = load.designs._buffer[i];
    CheckRobot(entry.robot);
    system_->robot(entry.robot).design_data[StringOf(entry.keyword)] = StringOf(entry.path);
  }
  std::vector<openr_wire_LoadedObject> loaded;
  for (uint32_t i = 0; i < load.objects._length; ++i) AddObject(load.objects._buffer[i], &loaded);
  SendLoaded(std::move(loaded));
  return "";
}

// Uses another folder of this host (WorkerOptions::own_stick) as the Memory Stick if the run's
// folder is not on this host.  `hash` is the hash of the files in the run's folder; the other
// folder must have the same files.
void Worker::FindStick(uint64_t hash) {
  if (IsFolder(stick_) || !options_.own_stick) return;
  const std::string own = options_.own_stick();
  if (IsFolder(own) && FolderStick(own).ContentHash() == hash) stick_ = own;
}

std::string Worker::AddRobot(const openr_wire_RobotEntry& entry) {
  std::shared_ptr<FolderStick> stick;
  if (entry.has_stick) {
    FindStick(entry.stick_hash);
    // Refuses the run if the stick is wrong.  A refusal is no loss of the worker, so the run may
    // wait for a worker with the right stick.
    is_refused_ = !IsFolder(stick_);
    if (is_refused_)
      return fmt::format("{}: there is no such folder here; give a copy of the run's (--stick)",
                         stick_);
    stick = std::make_shared<FolderStick>(stick_);
    stick->set_writable(entry.writable);
    is_refused_ = entry.stick_hash != 0 && stick->ContentHash() != entry.stick_hash;
    if (is_refused_)
      return fmt::format("{}: is not the stick of the run: its files differ from the master's",
                         stick_);
  }
  Robot& robot = system_->robot(system_->AddRobot(StringOf(entry.design), std::move(stick)));
  robot.services = std::make_unique<RemoteServices>(this, &system_->regions());
  return "";
}

void Worker::CheckRobot(int robot) const {
  if (robot < 0 || robot >= system_->robot_count())
    throw std::runtime_error("something of a robot that is not there");
}

// Adds an object of the master's tables.  Objects come in the order of their ids, so each object
// gets the same id in this process as in the master.
void Worker::AddObject(const openr_wire_ObjectEntry& entry,
                       std::vector<openr_wire_LoadedObject>* loaded) {
  const ObjectId next = system_->object_table().NextId();
  if (entry.id < next) return;  // skips the object manager, which every System has already
  if (entry.id > next) throw std::runtime_error("an object before those that come first");
  CheckRobot(entry.robot);
  // Gives the network stack of this process an empty network.  This stack serves only the shared
  // buffers of the objects in this process.  Only the stack in the master uses the real network.
  if (entry.is_stack) {
    IpStackOptions options;
    options.reports_settings = false;
    AddIpStack(system_.get(), entry.robot, std::make_unique<LoopbackNetwork>(), std::move(options));
    return;
  }
  if (entry.is_own) {
    loading_ = entry.id;
    Object* const object =
        LoadImage(system_.get(), entry.robot, StringOf(entry.path), "join", "", entry.last_box);
    loading_ = kNoObject;
    if (object != nullptr) {
      own_object_names_.insert(object->name);
      loaded->push_back(Describe(*object));
      return;
    }
    // Tells the master why the object cannot be loaded.  The master reports this error.
    openr_wire_LoadedObject bad{};
    bad.id = entry.id;
    bad.name = arena_.Text(StringOf(entry.name));
    const auto& findings = system_->findings().all();
    bad.problem = arena_.Text(findings.empty() ? "cannot be loaded" : findings.back().text);
    loaded->push_back(bad);
  }
  auto absent = std::make_unique<AbsentObject>(system_.get(), next, entry.robot, marshaller_.get());
  absent->name = StringOf(entry.name);
  absent->set_system(entry.is_system);
  system_->object_table().Adopt(std::move(absent));
}

openr_wire_LoadedObject Worker::Describe(const Object& object) {
  openr_wire_LoadedObject out{};
  out.id = object.id;
  out.name = arena_.Text(object.name);
  out.problem = arena_.Text("");
  out.priority = object.limits().priority;
  out.stack_bytes = object.limits().stack_bytes;
  out.heap_bytes = object.limits().heap_bytes;
  out.heap_here = HeapOfThisProcess(object.robot);
  std::vector<uint64_t> selectors;
  for (uint32_t i = 0; i < kSelectorMax; ++i) {
    if (object.HasEntry(i)) selectors.push_back(i);
  }
  out.selectors = arena_.Numbers(selectors);
  std::vector<openr_wire_EntryName> names;
  for (const auto& [selector, name] : object.entry_names().names())
    names.push_back({selector, arena_.Text(name)});
  out.names = arena_.Sequence<decltype(out.names)>(names);
  return out;
}

void Worker::SendLoaded(std::vector<openr_wire_LoadedObject> loaded) {
  openr_wire_ToMaster to_master = NewToMaster(openr_wire_TO_MASTER_LOADED);
  auto& objects = to_master.body._u.loaded.objects;
  objects = arena_.Sequence<std::remove_reference_t<decltype(objects)>>(loaded);
  MoveEffectsTo(&to_master);
  Send(to_master);
  arena_.Clear();
}

// Sets the number of heap bytes on `robot` that objects in other processes use.  These bytes count
// in this process too, because all objects of a robot share its memory, even in different
// processes.
void Worker::SetHeapOfOtherProcesses(int robot, uint64_t bytes) {
  system_->robot(robot).memory.used_bytes +=
      bytes - std::exchange(heap_of_other_processes_[robot], bytes);
}

uint64_t Worker::HeapOfThisProcess(int robot) const {
  const auto elsewhere = heap_of_other_processes_.find(robot);
  return system_->robot(robot).memory.used_bytes -
         (elsewhere == heap_of_other_processes_.end() ? 0 : elsewhere->second);
}

}  // namespace openr_host
