// Runs a recorded run again and compares it message by message.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "openr/inspect/trace_file.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/temp_folder.h"

namespace openr_host {

struct ReplayOptions {
  std::string file;
  std::string stick;  // "": the one that was recorded
  std::function<void(std::string_view)> console;
};

class Replayer {
 public:
  // Builds the run up to Boot(), on a copy of the stick as it was then.  Throws std::runtime_error
  // when the recording or what it was made of cannot be used, or somebody else than the recorded
  // run has changed the stick.
  explicit Replayer(const ReplayOptions& options);
  ~Replayer();
  Replayer(const Replayer&) = delete;
  Replayer& operator=(const Replayer&) = delete;

  Simulation& simulation() { return *simulation_; }
  System& system() { return simulation_->system(); }

  // Delivers one message and all input that comes before the next.  False at the end of the
  // recording or after a difference.
  bool Step();
  // To the end of the recording, to `time_us`, or to the first difference.
  void RunUntil(int64_t time_us);

  // What the recording says of the message delivered last.
  const TraceEntry& last() const { return last_; }
  // When the next message or input of the recording comes; INT64_MAX at its end.
  int64_t NextTimeUs();
  uint64_t count() const { return count_; }  // messages that were equal
  // How many messages the recording has up to the one of that number; nullopt when it has none
  // such.
  std::optional<uint64_t> CountUpTo(uint64_t number) const;
  bool at_end() const { return at_end_; }
  // Why it ends before the run did that was recorded: a process was lost; "".
  const std::string& loss() const { return loss_; }

  // The first difference, with number, time, port and byte; "" while there is none.
  const std::string& difference() const { return difference_; }
  // Damage of the file, as far as it was met.
  const std::vector<std::string>& problems() const { return reader_.problems(); }
  const TraceReader& reader() const { return reader_; }

 private:
  static SimulationOptions OptionsOf(const TraceHeader& header, const ReplayOptions& options);
  std::string StickOfThen(const std::string& now);
  std::vector<NetworkEvent> SayNetwork(int robot);
  void SkipNames();
  void Compare(const TraceRecord& record, const Message& message);
  void Differ(const TraceEntry& recorded, const std::string& what);
  void CompareFields(const TraceEntry& recorded, const TraceRecord& record);
  void ComparePayload(const TraceEntry& recorded, const Message& message);
  bool ApplyInput();
  void EndAtLoss();
  void CompareEnd(const TraceEntry& end);

  const std::string file_;
  TraceReader reader_;
  TempFolder folder_;  // of the copy of the stick
  std::unique_ptr<Simulation> simulation_;
  TraceEntry last_;
  uint64_t count_ = 0;
  bool at_end_ = false;
  std::string difference_;
  std::string loss_;
};

}  // namespace openr_host
