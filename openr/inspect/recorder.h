// Writes a run down while it runs.
#pragma once

#include <memory>
#include <string>

#include "openr/ending/last_words.h"
#include "openr/inspect/trace_file.h"
#include "openr/simulation/simulation.h"

namespace openr_host {

class Recorder {
 public:
  Recorder(std::string file, bool payloads) : file_(std::move(file)), payloads_(payloads) {}

  // Makes the networks of a simulation that is still to be made report here.
  void Listen(SimulationOptions* options);

  // Begins the file; throws std::runtime_error when it cannot be made, or another run is writing
  // it. REQUIRES: before Boot(); `options` are those of `simulation`; `stick`: where a replay finds
  // the files (RunStick::name()); `is_free`: the run is free-running and cannot be replayed.
  void Begin(Simulation* simulation, const SimulationOptions& options, const std::string& stick,
             bool is_free = false);

  void NotePause(int64_t time_us) { writer_->AddAt(TraceEntry::Kind::kPause, time_us); }
  void NoteShutdown(int64_t time_us) { writer_->AddAt(TraceEntry::Kind::kShutdown, time_us); }

  void NoteLoss(const std::string& process, int64_t time_us) { writer_->AddLoss(process, time_us); }

  // Returns what went wrong with the file, or "".
  std::string Finish(System* system) { return writer_->Finish(system); }

 private:
  const std::string file_;
  const bool payloads_;
  std::unique_ptr<TraceWriter> writer_;
  std::unique_ptr<LastWords> last_words_;
};

}  // namespace openr_host
