#include "distribution/worker_group.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "distribution/end_workers.h"
#include "distribution/join_advice.h"
#include "distribution/latency.h"
#include "distribution/remote_object.h"
#include "runtime/base/assert.h"
#include "runtime/base/spelling.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

// The interval at which a free run checks that its workers still exist.  Each check costs system
// calls, so we do not check in every call of Pump().
constexpr int64_t kHealthIntervalNs = 10'000'000;
// Time for all workers together to receive the samples that end them.  It is so long because a
// worker on a busy machine may get no processor time for seconds.
constexpr int64_t kEndFlushMs = 5'000;
constexpr int64_t kExitWaitMs = 5'000;  // time for all workers to end after they were told to end
// Replaces kEndFlushMs and kExitWaitMs after a second Ctrl-C, when the user does not want to wait.
// The second Ctrl-C may also come while the master waits already; then the rest of the wait lasts
// at most this time.
constexpr int64_t kInterruptedWaitMs = 500;

// Returns the options of the bus.  The bus keeps many sent samples only in a free run.  In a free
// run the master does not wait for workers, so a stopped worker must not block a write of the
// master.  In lockstep the master waits for a stopped worker anyway.
BusOptions GroupBusOptions(const WorkerGroupOptions& options) {
  BusOptions bus = options.bus;
  bus.has_large_history = options.is_free;
  return bus;
}

}  // namespace

WorkerGroup::WorkerGroup(WorkerGroupOptions options)
    : options_(std::move(options)), bus_(GroupBusOptions(options_)) {
  // Claims the run's name only if there are external workers, because only external workers look
  // for a run by its name.
  if (!options_.placement.host_of.empty()) claim_ = std::make_unique<NameClaim>(&bus_);
  for (const std::string& name : options_.placement.Processes()) {
    Member* const member = &members_[name];
    member->name = name;
    member->is_external = options_.placement.host_of.contains(name);
    member->restarts_left = options_.restarts;
    member->process = std::make_unique<RemoteProcess>(
        &bus_, name, member->is_external, [this, member] { return ProblemOf(*member); },
        options_.say);
    if (!member->is_external) Start(member);
  }
}

// Returns the reason why the worker cannot go on, or "" if it can.  As long as an external worker
// has not joined, an earlier run of the same name is a problem too, because the worker could join
// that run instead of this run.
std::string WorkerGroup::ProblemOf(const Member& member) const {
  if (IsInterrupted()) return "interrupted";
  if (member.child != nullptr) return member.child->EndText();
  const std::string earlier_run =
      member.is_external && !member.is_welcomed ? claim_->EarlierRun() : "";
  if (earlier_run.empty()) return "";
  return fmt::format(
      "there is a run of the name '{}' already ({}), and openr join would not know where to go; "
      "give this one another name (--run-name)",
      options_.bus.run, earlier_run);
}

void WorkerGroup::Start(Member* member) {
  // Gives each process a new session name, so that samples for an earlier process of the same name
  // never reach this process.
  const std::string session = NewSessionName();
  member->process->connection().slot().OpenSession(session);
  std::vector<std::string> command = options_.wrapper;
  command.insert(command.end(), options_.command.begin(), options_.command.end());
  command.insert(command.end(), {"--process", member->name, "--session", session});
  member->child = std::make_unique<ChildProcess>(member->name, command, !options_.wrapper.empty());
}

WorkerGroup::~WorkerGroup() = default;

StandIns WorkerGroup::StandInsFor(System* system, int robot) {
  if (system_ == nullptr) system->object_table().OnReplace([this](ObjectId id) { OnReplaced(id); });
  system_ = system;
  StandIns stand_ins;
  for (const auto& [object_name, process_name] : options_.placement.process_of) {
    stand_ins[object_name] = [this, robot, name = object_name,
                              member = &members_[process_name]](const std::string& path) {
      const ObjectId id = system_->object_table().NextId();
      auto object = std::make_unique<RemoteObject>(
          system_, id, robot, member->process.get(),
          [this](const RemoteObject* about, RemoteObject::Loss loss, const std::string& why) {
            HandleLoss(about, loss, why);
          });
      object->name = name;
      object->path = path;
      member->objects[id] = object.get();
      member->process->resources().Add(object.get());
      placed_.push_back(name);
      system_->object_table().Adopt(std::move(object));
      // Lets the worker load the object as soon as OBJECT.CFG names it, and not later in Connect(),
      // so that the objects of all processes are loaded in the order in which OBJECT.CFG names
      // them.
      LoadNewObjects(member);
    };
  }
  return stand_ins;
}

std::string WorkerGroup::UnknownObjects() const {
  ASSERT(system_ != nullptr);
  std::vector<std::string> known, of_the_robot;
  for (const auto& object : system_->objects()) {
    std::vector<std::string>* const names = object->is_system() ? &of_the_robot : &known;
    if (std::find(names->begin(), names->end(), object->name) == names->end())
      names->push_back(object->name);
  }
  for (const auto& [name, process] : options_.placement.process_of) {
    if (std::find(placed_.begin(), placed_.end(), name) != placed_.end()) continue;
    if (std::find(of_the_robot.begin(), of_the_robot.end(), name) != of_the_robot.end())
      return fmt::format(
          "{} cannot be placed in process '{}': it is the robot's own and stays in openr run, with "
          "body and clock; objects of OBJECT.CFG can: {}",
          name, process, fmt::join(known, ", "));
    return fmt::format("{} is placed in process '{}', but OBJECT.CFG names {} only{}", name,
                       process, fmt::join(known, ", "), DidYouMean(name, known));
  }
  return "";
}

std::string WorkerGroup::Connect() {
  ASSERT(system_ != nullptr && !system_->booted());
  // Computes no trace hash in a free run, because the master does not wait for handlers, so the
  // order of messages differs from run to run.
  if (options_.is_free) system_->trace().set_hashing(false);
  for (auto& [name, member] : members_) {
    LoadNewObjects(&member);
    if (problem_.empty() && options_.is_free) member.process->handlers().RunFree();
  }
  return problem_;
}

void WorkerGroup::Welcome(Member* member) {
  WireArena arena;
  openr_wire_Welcome welcome{};
  const SystemOptions& options = system_->options();
  welcome.version = openr_wire_VERSION;
  welcome.seed = options.seed;
  welcome.strict = options.strict;
  welcome.guard = options.guard_regions;
  welcome.measure = options.measure_stacks;
  welcome.free_running = options_.is_free;
  welcome.log_level = options.log_level;
  welcome.stick = arena.Text(options_.stick);
  member->process->loader().Welcome(system_, welcome);
  member->is_welcomed = true;
  if (member->is_external) claim_->MakePermanent();
}

// Returns the entries of the master's tables of robots and objects that the worker has not
// received, up to the next object of the worker, and counts them as sent.  A restarted worker loads
// its objects one by one, as at the beginning of the run, so that each object's constructors have a
// sample of their own for their effects.
openr_wire_Load WorkerGroup::NextLoadFor(Member* member, WireArena* arena) {
  openr_wire_Load load{};
  load.now_us = system_->now_us();
  std::vector<openr_wire_RobotEntry> robots;
  std::vector<openr_wire_DesignEntry> designs;
  std::vector<openr_wire_ObjectEntry> objects;
  for (int i = 0; i < system_->robot_count(); ++i) {
    const Robot& robot = system_->robot(i);
    for (const auto& [keyword, path] : robot.design_data)
      designs.push_back({i, arena->Text(keyword), arena->Text(path)});
    if (static_cast<size_t>(i) < member->robots_sent) continue;
    // Sends 0 as the hash of the run's stick at a restart, so that the worker does not compare it
    // with the hash of its own stick.  Objects may have written files since the beginning of the
    // run, and the user may have replaced an image in order to try new code.
    const uint64_t stick_hash = member->stage == Stage::kRunning ? robot.stick_hash : 0;
    robots.push_back({arena->Text(robot.design), robot.stick != nullptr,
                      robot.stick != nullptr && robot.stick->writable(), stick_hash});
  }
  member->robots_sent = static_cast<size_t>(system_->robot_count());
  ASSERT(member->objects_sent <= system_->objects().size(), "{}", member->objects_sent);
  for (bool is_own = false; !is_own && !HasSentAll(*member); ++member->objects_sent) {
    const Object& object = *system_->objects()[member->objects_sent];
    is_own = member->objects.contains(object.id);
    objects.push_back({object.id, object.robot, arena->Text(object.name), arena->Text(object.path),
                       object.is_system(), object.name == IpStack::kName, is_own,
                       object.boxes().last()});
  }
  // Sends the heap use of all robots with every Load, and not only of new robots, because objects
  // in other processes may have used more heap since the previous Load.
  std::vector<uint64_t> heap_elsewhere;
  for (int i = 0; i < system_->robot_count(); ++i)
    heap_elsewhere.push_back(member->process->resources().HeapOfOtherProcesses(system_, i));
  load.heap_elsewhere = arena->Numbers(heap_elsewhere);
  load.robots = arena->Sequence<decltype(load.robots)>(robots);
  load.designs = arena->Sequence<decltype(load.designs)>(designs);
  load.objects = arena->Sequence<decltype(load.objects)>(objects);
  return load;
}

// Returns whether the worker has received all entries of the master's table of objects.
bool WorkerGroup::HasSentAll(const Member& member) const {
  return member.objects_sent == system_->objects().size();
}

// Sends the worker the new entries of the master's tables of robots and objects, and waits until
// the worker has loaded the new objects that belong to it.  The first time, also waits until the
// worker has joined.
void WorkerGroup::SendNewEntries(Member* member) {
  if (!member->is_welcomed) {
    const auto host = options_.placement.host_of.find(member->name);
    const std::string advice = host == options_.placement.host_of.end()
                                   ? ""
                                   : JoinAdvice(member->name, host->second, options_.bus);
    member->process->connection().WaitForJoin(options_.wait_ms, advice,
                                              [this] { return IsEnding(); });
    Welcome(member);
  }
  do {
    WireArena arena;
    member->process->loader().Load(NextLoadFor(member, &arena));
  } while (!HasSentAll(*member));
}

void WorkerGroup::LoadNewObjects(Member* member) {
  while (problem_.empty()) {
    const bool is_first = member->robots_sent == 0;
    try {
      return SendNewEntries(member);
    } catch (const ProcessRefused& refused) {
      if (!is_first || !member->is_external) {
        problem_ = refused.what();
      } else {
        WaitForAnotherWorker(member, refused.what());
      }
    } catch (const ProcessCrashed& crashed) {
      HandleLoadingCrash(*member, crashed);
    } catch (const ProcessLost& lost) {
      problem_ = lost.what();
    }
  }
}

// Handles a crash of a constructor, or a constructor that does not return, in a worker that loads
// its objects for the first time.  The run cannot begin without these objects.
void WorkerGroup::HandleLoadingCrash(const Member& member, const ProcessCrashed& crashed) {
  const auto found = member.objects.find(crashed.object);
  const RemoteObject* const object =
      found == member.objects.end() ? member.objects.begin()->second : found->second;
  const std::string why = fmt::format("{}; process '{}' (pid {}) is gone", crashed.what(),
                                      member.name, member.process->connection().identity().pid);
  problem_ = fmt::format("{}: {}", object->name, why);
  HandleLoss(object, RemoteObject::Loss::kAtEnd, why);
}

// Lets another process join in place of a worker that has refused the run, for instance because its
// stick was wrong.  The user may then start a worker with the right stick.
void WorkerGroup::WaitForAnotherWorker(Member* member, const std::string& why) {
  options_.say(fmt::format("{}; the run waits for another one", why));
  member->process->connection().slot().Abandon();
  member->is_welcomed = false;
  member->robots_sent = member->objects_sent = 0;
}

// Handles the loss of a worker.  After a crash the run goes on: the handler crashes at the same
// message in every run, so all runs go on in the same way.  After any other loss, a run in lockstep
// (the master waits for each handler) would wait for the worker for ever.  So such a run stops,
// unless the worker may be restarted.
void WorkerGroup::HandleLoss(const RemoteObject* about, RemoteObject::Loss loss,
                             const std::string& why) {
  RemoteProcess& process = *about->process();
  if (process.is_lost()) return;
  Member* const member = &members_[process.name()];
  // Calls the listener for lost workers before anything changes, so that a recording of the run has
  // the loss before its consequences.
  if (loss_listener_ && loss != RemoteObject::Loss::kAtEnd) loss_listener_(member->name);
  // Adds no finding about a loss after a second Ctrl-C, because after that signal workers may end
  // at any time.  Only a crash is still reported, because its cause is a handler and not the
  // signal.
  if (IsInterrupted() && loss != RemoteObject::Loss::kCrashed) {
    process.SetLost();
    return StopRun(
        {EndKind::kSignal, "Ctrl-C or SIGTERM came again while a process was waited for"});
  }
  member->lost = why;
  member->crashed = loss == RemoteObject::Loss::kCrashed;
  ++member->losses;
  // If the loss was noticed after the run, only reports it, because nothing has to be cleaned up or
  // restarted.
  if (loss == RemoteObject::Loss::kAtEnd) {
    process.SetLost();
    system_->AddFindingAbout(about, Severity::kError, why);
    return;
  }
  std::string text = why;
  uint64_t pending = 0;
  for (const auto& [id, object] : member->objects) pending += object->pending_count;
  if (pending > 0) text += fmt::format("; {} notifications that waited in it are lost", pending);
  const size_t undelivered = process.free_run().CountUndelivered();
  if (undelivered > 0)
    text += fmt::format("; {} messages that it had been handed are lost", undelivered);
  if (!member->crashed && !options_.is_free && !MayRestart(*member)) {
    if (options_.restarts > 0)
      text += fmt::format("; it was started again {} times", options_.restarts);
    system_->AddFindingAbout(about, Severity::kError, fmt::format("{}; the run stops here", text));
    process.SetLost();
    return StopRun({EndKind::kLostProcess, text});
  }
  // Names the process in the message only after a crash, because for other losses the text `why`
  // names the process already.
  if (member->crashed)
    text += fmt::format("; process '{}' (pid {}) is gone", process.name(),
                        process.connection().identity().pid);
  const bool waits = !options_.is_free && MayRestart(*member);
  text += waits ? "; the run waits for it to come back" : "; the others go on";
  options_.say(text);
  system_->AddFindingAbout(about, Severity::kError, text);
  process.ReleaseAll();
  CleanUp(member);
  if (!object_loss_listener_) return;
  for (const auto& [id, object] : member->objects) object_loss_listener_(object);
}

void WorkerGroup::StopRun(const RunEnd& why) {
  for (int robot = 0; robot < system_->robot_count(); ++robot) system_->PowerOff(robot, why);
}

bool WorkerGroup::HandleReceived() {
  bool came = false;
  for (auto& [name, member] : members_) {
    if (!member.process->is_lost()) came = member.process->free_run().HandleReceived() || came;
  }
  return came;
}

void WorkerGroup::Pump(int64_t timeout_us) {
  // Sends the samples (DDS messages) that SendBatched() has kept back so that several share a
  // packet.  Workers may be idle until they get these samples.
  for (auto& [name, member] : members_) member.process->connection().FlushBatch();
  if (!HandleReceived()) {
    bus_.Wait(timeout_us);
    // Returns after a second Ctrl-C.  The workers then end because the user wants it, so their end
    // is not a loss.
    if (IsInterrupted()) return;
    HandleReceived();
  }
  const int64_t now_ns = WallClockNs();
  const bool is_time = now_ns >= next_check_ns_;
  if (is_time) next_check_ns_ = now_ns + kHealthIntervalNs;
  for (auto& [name, member] : members_) {
    RemoteProcess& process = *member.process;
    AdvanceRestart(&member);
    if (process.is_lost()) continue;
    if (is_time) process.free_run().CheckHealth();
    const RemoteFreeRun::Loss& loss = process.free_run().loss();
    if (loss.why.empty()) continue;
    const auto crashed_object = member.objects.find(loss.crashed_object);
    HandleLoss(crashed_object == member.objects.end() ? member.objects.begin()->second
                                                      : crashed_object->second,
               loss.has_crashed ? RemoteObject::Loss::kCrashed : RemoteObject::Loss::kGone,
               loss.why);
  }
}

void WorkerGroup::CheckWorkers() {
  // Does nothing in a free run, where Pump() checks the workers, or if the run is about to end.
  if (options_.is_free || IsInterrupted()) return;
  for (auto& [name, member] : members_) {
    if (!IsRestarting(member)) AdvanceRestart(&member);
    if (member.process->is_lost()) continue;
    const std::string problem = member.process->connection().FindLoss();
    if (!problem.empty())
      HandleLoss(member.objects.begin()->second, RemoteObject::Loss::kGone, problem);
  }
  WaitForRestarts();
}

void WorkerGroup::ShortenTimeouts() {
  for (auto& [name, member] : members_) member.process->connection().ShortenTimeouts();
}

void WorkerGroup::ReportLosses() {
  for (const auto& [name, member] : members_) {
    for (const auto& [id, object] : member.objects) {
      if (object->undelivered_count == 0) continue;
      system_->AddFindingAbout(object, Severity::kWarning,
                               fmt::format("{} messages came after process '{}' was gone; nobody "
                                           "heard them",
                                           object->undelivered_count, name));
    }
  }
}

std::vector<WorkerGroup::ProcessFacts> WorkerGroup::Describe() const {
  std::vector<ProcessFacts> all;
  for (const auto& [name, member] : members_) {
    ProcessFacts facts{name,
                       member.process->connection().slot().last_identity().host,
                       member.process->connection().slot().last_identity().pid,
                       {},
                       member.lost,
                       member.losses,
                       member.restarts_done};
    const Latency& latency = member.process->handlers().latency();
    facts.handlers = latency.count();
    facts.median_us = latency.PercentileUs(0.5);
    facts.p99_us = latency.PercentileUs(0.99);
    facts.max_us = latency.MaxUs();
    for (const auto& [id, object] : member.objects) facts.objects.push_back(object->name);
    all.push_back(std::move(facts));
  }
  return all;
}

std::map<ObjectId, uint64_t> WorkerGroup::HeapMax() const {
  std::map<ObjectId, uint64_t> all;
  for (const auto& [name, member] : members_) {
    for (const auto& [id, object] : member.objects) all[id] = object->heap_max;
  }
  return all;
}

void WorkerGroup::ReleaseSystem() {
  for (auto& [name, member] : members_) {
    DropNewObjects(&member);  // their outboxes have messages of the System
    member.process->resources().End();
  }
}

void WorkerGroup::End() {
  const std::string why = system_ != nullptr && system_->end() ? DescribeEnd(*system_->end()) : "";
  std::vector<EndingWorker> workers;
  for (auto& [name, entry] : members_) {
    Member* const member = &entry;
    // Must be called while the System exists, because the outboxes of the new stand-ins may have
    // messages of the System.
    DropNewObjects(member);
    workers.push_back({[member, why] { return member->process->SendEnd(why); },
                       [member] { return HasEnded(*member); },
                       [member](int64_t limit_ms) {
                         return member->process->connection().AwaitReceipt(limit_ms);
                       },
                       [member](int64_t limit_ms) { return AwaitExit(*member, limit_ms); },
                       [this, member] { KillAtEnd(*member); }});
  }
  EndWorkers(
      workers, {kEndFlushMs, kExitWaitMs, kInterruptedWaitMs}, [this] { return IsInterrupted(); },
      WallClockMs);
}

// Returns whether the process of the worker has ended, as far as this machine can tell.
bool WorkerGroup::HasEnded(const Member& member) {
  if (member.child != nullptr) return !member.child->EndText().empty();
  return member.process->connection().slot().HasEnded();
}

// Waits for the end of a worker's process, at most `limit_ms`.  Returns whether the process has
// ended.  Does not wait for a process that has never joined, but kills it, because it was not told
// that the run is over.  A lost worker was not told either, but is not killed here, because it may
// be writing the record of its crash.
bool WorkerGroup::AwaitExit(const Member& member, int64_t limit_ms) {
  if (member.child == nullptr) return true;
  if (member.process->connection().identity().pid != 0) return member.child->WaitForEnd(limit_ms);
  member.child->Kill();
  return true;
}

void WorkerGroup::KillAtEnd(const Member& member) const {
  member.child->Kill();
  options_.say(
      fmt::format("process '{}' (pid {}) did not end with the run and was killed; what its "
                  "objects had not written yet is lost",
                  member.name, member.process->connection().identity().pid));
}

}  // namespace openr_host
