// Records a run to a file.
#pragma once

#include <memory>
#include <string>

#include "openr/ending/ending.h"
#include "openr/inspect/trace_file.h"
#include "openr/simulation/simulation.h"

namespace openr_host {

class Recorder {
 public:
  Recorder(std::string file, bool payloads) : file_(std::move(file)), payloads_(payloads) {}

  // Sets `options` so that the networks of the simulation report to this recorder.  Called before
  // the simulation is made.
  void Listen(SimulationOptions* options);

  // Begins the file.  Throws std::runtime_error when it cannot be created or another run writes to
  // it.  `stick` is the folder in which a replay finds the files (RunStick::name()).  `is_free`
  // says that the run is free-running and cannot be replayed.  REQUIRES: System::Boot() has not
  // been called; `simulation` was made with `options`.
  void Begin(Simulation* simulation, const SimulationOptions& options, const std::string& stick,
             bool is_free = false);

  void NotePause(int64_t time_us) { writer_->AddAt(TraceEntry::Kind::kPause, time_us); }
  void NoteShutdown(int64_t time_us) { writer_->AddAt(TraceEntry::Kind::kShutdown, time_us); }

  void NoteLoss(const std::string& process, int64_t time_us) { writer_->AddLoss(process, time_us); }

  // Ends the file.  Returns "" or the error in writing it.
  std::string Finish(System* system) { return writer_->Finish(system); }

 private:
  const std::string file_;
  const bool payloads_;
  std::unique_ptr<TraceWriter> writer_;
  std::unique_ptr<EndingAction> ending_action_;
};

}  // namespace openr_host
