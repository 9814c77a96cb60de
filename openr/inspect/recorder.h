// Records a run to a file, from which openr replay can run it again.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "openr/ending/ending.h"
#include "openr/inspect/trace_file.h"
#include "openr/simulation/simulation.h"

namespace openr_host {

class Recorder {
 public:
  Recorder(std::string file, bool payloads) : file_(std::move(file)), payloads_(payloads) {}

  // Changes `options` so that a recording network stands between each robot and its network.  If
  // `options` already puts another network there, the recording network stands between the robot
  // and that network.  The recording network passes all calls on, and gives this recorder all
  // events from outside.  Must be called before the simulation is made with `options`.
  void RecordNetworks(SimulationOptions* options);

  // Begins the file of the recording.  `stick` is the folder in which a replay finds the files of
  // the Memory Stick (RunStick::name()).  `schedule` is the order of messages as in
  // TraceHeader::schedule.  `is_free` says that the run is free-running and cannot be replayed.
  // Throws std::runtime_error when the file cannot be created or another run is writing to it.
  // REQUIRES: System::Boot() has not been called; `simulation` was made with `options`.
  void Begin(Simulation* simulation, const SimulationOptions& options, const std::string& stick,
             bool is_free = false, const std::string& schedule = "");

  // Adds entries with the content that files of the Memory Stick had at the beginning of an older
  // run, which this run continues.
  void AddStick(const std::vector<TraceEntry>& entries);

  void NoteLoss(const std::string& process, int64_t time_us) { writer_->AddLoss(process, time_us); }

  // Writes the end of the recording, with the hashes that a replay compares with its own.  Returns
  // "", or the error that happened while the file was written.
  std::string Finish(System* system) { return writer_->Finish(system); }

 private:
  const std::string file_;
  const bool payloads_;
  std::unique_ptr<TraceWriter> writer_;
  std::unique_ptr<EndingAction> ending_action_;
};

}  // namespace openr_host
