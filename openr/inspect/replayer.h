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
  std::string stick;  // folder; "": the stick of the recording
  std::function<void(std::string_view)> console;
};

class Replayer {
 public:
  // Assembles the run up to Boot(), on a copy of the stick as it was then.  Throws
  // std::runtime_error when the recording, or a file that it needs, cannot be used, or when the
  // stick was changed by others than the recorded run.
  explicit Replayer(const ReplayOptions& options);
  ~Replayer();
  Replayer(const Replayer&) = delete;
  Replayer& operator=(const Replayer&) = delete;

  Simulation& simulation() { return *simulation_; }
  System& system() { return simulation_->system(); }

  // Delivers one message, and all input before the next one.  Returns false at the end of the
  // recording and after a difference.
  bool Step();
  // Runs to the end of the recording, to `time_us`, or to the first difference.
  void RunUntil(int64_t time_us);

  // Returns the recording's entry for the last message.
  const TraceEntry& last() const { return last_; }
  // Returns the time of the next message or input in the recording; INT64_MAX at its end.
  int64_t NextTimeUs();
  uint64_t count() const { return count_; }  // messages that were equal
  // Returns how many messages the recording has up to the message `number`; nullopt if there is no
  // such message.
  std::optional<uint64_t> CountUpTo(uint64_t number) const;
  bool at_end() const { return at_end_; }
  // Returns the reason why the replay ends before the recorded run did: a process was lost.  "" if
  // the replay does not.
  const std::string& loss() const { return loss_; }

  // Returns a text about the first difference, with number, time, port and byte; "" while there is
  // none.
  const std::string& difference() const { return difference_; }
  // Returns the damage of the file found so far.
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
  TempFolder folder_;  // holds the copy of the stick
  std::unique_ptr<Simulation> simulation_;
  TraceEntry last_;
  uint64_t count_ = 0;
  bool at_end_ = false;
  std::string difference_;
  std::string loss_;
};

}  // namespace openr_host
