#include "openr/commands/distributed_run.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "openr/ending/crash_log.h"
#include "openr/inspect/recorder.h"
#include "openr/run/interrupt.h"
#include "openr/simulation/run_stick.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

nlohmann::ordered_json DescribeProcesses(const WorkerGroup& workers) {
  auto processes = nlohmann::ordered_json::array();
  for (const WorkerGroup::ProcessFacts& facts : workers.Describe()) {
    processes.push_back(
        {{"name", facts.name},
         {"pid", facts.pid},
         {"host", facts.host},
         {"objects", facts.objects},
         {"lost", facts.lost},
         {"losses", facts.losses},
         {"returns", facts.restarts_done},
         {"handlers", facts.handlers},
         {"handler_us",
          {{"median", facts.median_us}, {"p99", facts.p99_us}, {"max", facts.max_us}}}});
  }
  return processes;
}

}  // namespace

DistributedRun::DistributedRun(const PlacementFlags& placement, const Ros2Flags& ros2,
                               const RunStick& stick, int64_t handler_limit_us,
                               const InterruptCounter* interrupts)
    : is_free_(placement.is_free),
      ros2_flags_(ros2),
      workers_(MakeWorkerGroup(placement, stick, handler_limit_us,
                               [interrupts] { return interrupts->count(); })) {
  if (workers_ != nullptr) {
    bus_ = workers_->bus();
  } else if (ros2.is_on || placement.is_monitored) {
    own_bus_ = MakeBus(placement);
    bus_ = own_bus_.get();
  }
  // Removes the crash records of earlier runs, because each worker adds its record to the end of
  // the file.
  if (workers_ != nullptr) CrashLog::RemoveOldRecords(stick.crash_log());
  RefuseIdleFlags(placement, workers_ != nullptr, bus_ != nullptr);
}

void DistributedRun::ChangeOptions(SimulationOptions* options, const Ros2Link::Say& say) {
  if (workers_ != nullptr) {
    options->stand_ins = [this](System* system, int robot) {
      return workers_->StandInsFor(system, robot);
    };
  }
  if (ros2_flags_.is_on) ros2_ = std::make_unique<Ros2Link>(bus_, ros2_flags_.space, options, say);
}

void DistributedRun::CheckPlaces() const {
  const std::string problem = workers_ == nullptr ? "" : workers_->UnknownObjects();
  if (!problem.empty()) throw std::runtime_error(problem);
}

std::string DistributedRun::Connect(Simulation* simulation) {
  if (workers_ == nullptr) return "";
  const std::string problem = workers_->Connect();
  if (!problem.empty()) return problem;
  const auto robot_of = [simulation](const Object& object) {
    return simulation->robots()[static_cast<size_t>(object.robot)];
  };
  workers_->OnObjectLoss(
      [robot_of](Object* object) { robot_of(*object)->OnCommanderLost(object->id); });
  workers_->OnObjectRestart(
      [robot_of](Object* object) { robot_of(*object)->OnCommanderBack(object->id); });
  return "";
}

std::string DistributedRun::Problem() const {
  return workers_ == nullptr ? "" : workers_->problem();
}

void DistributedRun::Begin(Simulation* simulation, RunPlan* plan) {
  if (workers_ != nullptr && is_free_)
    plan->pump = [this](int64_t timeout_us) { workers_->Pump(timeout_us); };
  if (workers_ != nullptr && plan->recorder != nullptr) {
    workers_->OnLoss([simulation, recorder = plan->recorder](const std::string& process) {
      recorder->NoteLoss(process, simulation->system().now_us());
    });
  }
  plan->after_frame = [this] { AfterFrame(); };
  if (bus_ != nullptr)
    monitor_ = std::make_unique<Monitor>(&simulation->system(), bus_, workers_.get());
  if (ros2_ != nullptr) ros2_->Begin(simulation);
}

void DistributedRun::AfterFrame() {
  if (workers_ != nullptr) workers_->CheckWorkers();
  if (monitor_ != nullptr) monitor_->PublishIfDue();
  if (ros2_ != nullptr) ros2_->AfterFrame();
}

void DistributedRun::RunIsOver() {
  if (ros2_ != nullptr) ros2_->End();
  if (monitor_ != nullptr) monitor_->End();
}

void DistributedRun::ReportLosses() {
  if (workers_ != nullptr) workers_->ReportLosses();
}

void DistributedRun::ShortenTimeouts() {
  if (workers_ != nullptr) workers_->ShortenTimeouts();
}

void DistributedRun::Describe(nlohmann::ordered_json* report) const {
  if (workers_ == nullptr) return;
  (*report)["processes"] = DescribeProcesses(*workers_);
  // Leaves out the trace hash, because the messages of two free-running runs are never the same, so
  // a comparison of their hashes would say nothing.
  if (is_free_) report->erase("trace_hash");
  for (const auto& [id, bytes] : workers_->HeapMax())
    (*report)["objects"][static_cast<size_t>(id)]["heap_bytes_max"] = bytes;
}

void DistributedRun::EndProcesses() {
  if (workers_ != nullptr) workers_->End();
}

void DistributedRun::ReleaseSimulation() {
  if (workers_ != nullptr) workers_->ReleaseSystem();
}

}  // namespace openr_host
