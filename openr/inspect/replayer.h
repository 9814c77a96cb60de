// Runs a recorded run again and compares each message with the recording.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "openr/explore/explore_schedule.h"
#include "openr/explore/prepared_run.h"
#include "openr/inspect/answer_difference.h"
#include "openr/inspect/trace_file.h"
#include "openr/simulation/known_run.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/temp_folder.h"

namespace openr_host {

struct ReplayOptions {
  std::string file;
  std::string stick;  // folder of the Memory Stick; "": the folder that the recording names
  std::function<void(std::string_view)> console;
  // The name of an object whose messages are compared with the recording, see answer_difference.h.
  // The case of letters counts only if two objects differ in nothing else.  "" means that all
  // messages are compared, and that the replay ends at the first difference.
  std::string only = {};
  // A function that changes the options of the simulation before the simulation is made; null: the
  // options are not changed.
  std::function<void(SimulationOptions*)> prepare = {};
  // A function that is called before the boot, with the recorded changes of the Memory Stick; may
  // be null.
  std::function<void(Simulation*, const SimulationOptions&, const std::vector<TraceEntry>& changes)>
      begin = {};
};

// If images on a Memory Stick of the recording were built with openr build --sanitize, starts openr
// again with the library of AddressSanitizer (StartWithSanitizerOf()).  Commands call this before
// they construct a Replayer and before they open other files.
void StartWithSanitizerOfRecording(const ReplayOptions& options);

class Replayer : public KnownRun {
 public:
  // Assembles the run and boots it, on a copy of the Memory Stick with its content at the beginning
  // of the recorded run.  Throws std::runtime_error if the recording, or a file that it needs,
  // cannot be used, or if anything but the recorded run has changed files of the stick.
  explicit Replayer(const ReplayOptions& options);
  ~Replayer() override;
  Replayer(const Replayer&) = delete;
  Replayer& operator=(const Replayer&) = delete;

  Simulation& simulation() override { return *simulation_; }
  System& system() { return simulation_->system(); }

  // Applies the recorded input that is due, then goes on to what comes next in the recording.  If
  // that is a message, delivers one message and compares it with the recorded message.  If it is an
  // input, delivers nothing, and the next call applies the input.  Returns false at the end of the
  // recording and after a difference.
  bool Step();
  // ---- Functions of the base class KnownRun
  void RunOne(int64_t time_us) override;
  int64_t length_us() const override { return length_us_; }
  std::string EndReason() const override;

  // Returns the last message that was compared, as the recording has it.
  const TraceEntry& last() const { return last_; }
  // Returns the time of the next message or input in the recording; INT64_MAX at the end of the
  // recording.
  int64_t NextTimeUs();
  // Ends the comparison with the recording.  The run can then go on without the recording.
  void EndComparison() { at_end_ = true; }

  // Returns the exact name of the object that ReplayOptions::only names.  The user may have typed
  // this name with other capitals.
  const std::string& only() const { return only_; }
  // Returns how many messages of the object ReplayOptions::only were compared.
  uint64_t answer_count() const { return answer_count_; }
  // Returns the messages of the object ReplayOptions::only that differ from the recorded messages.
  const std::vector<AnswerDifference>& answer_differences() const { return answer_differences_; }

  // Returns how many messages so far were equal to the recording.
  uint64_t count() const { return count_; }
  // Returns how many messages the recording has up to and including the message with the number
  // `number`; nullopt if it has no such message.  This count may differ from `number`, because
  // messages are numbered when they are posted, but recorded when they are delivered.
  std::optional<uint64_t> CountUpTo(uint64_t number) const;
  bool at_end() const { return at_end_; }
  // Returns why the replay has ended early; "" if it has not ended early.  A replay ends early
  // where a worker process of the recorded run was lost (crashed or answered no more), because a
  // replay cannot repeat what followed.
  const std::string& loss() const { return loss_; }

  // Returns a text about the first difference between the replay and the recording: message, time,
  // sender, receiver, entry, content in words, and what differs.  Returns "" while no difference
  // was found.
  const std::string& difference() const { return difference_; }
  // Returns texts about damaged places of the recording that have been found so far.
  const std::vector<std::string>& problems() const { return reader_.problems(); }
  const TraceReader& reader() const { return reader_; }

 private:
  static SimulationOptions OptionsOf(const TraceHeader& header, const ReplayOptions& options);
  std::string RestoreStick(const std::string& now, const std::vector<TraceEntry>& changes);
  std::vector<NetworkEvent> NextNetworkEvents(int robot);
  void SkipNames();
  void Compare(const TraceRecord& record, const Message& message);
  // Returns the name of the entry (handler) that gets the recorded message `message`.
  std::string EntryOf(const TraceEntry& message) const;
  // Sets difference_ to a text about the recorded message `recorded`.  `what` tells how the replay
  // differs from the recorded message.
  void Differ(const TraceEntry& recorded, const std::string& what);
  void CompareFields(const TraceEntry& recorded, const TraceRecord& record, const Message& message);
  std::string FindOnly(const std::string& name);
  bool IsAnswer(const TraceRecord& record) const;
  void CompareAnswerOf(const Message& message, const TraceRecord& record);
  void MakeRun(SimulationOptions options);
  void ComparePayload(const TraceEntry& recorded, const Message& message, uint64_t hash);
  bool ApplyInput();
  void DifferAfterLast(const TraceRecord& record, const Message& message, int64_t end_us);
  void EndAtLoss();
  void CompareEnd(const TraceEntry& end);

  const std::string file_;
  TraceReader reader_;
  TempFolder folder_;  // holds the copy of the Memory Stick
  // Owns the run if the recording has a schedule; else empty.
  PreparedRun prepared_;
  // Schedule of the recording; null: the seed decides the order of messages.
  std::unique_ptr<ExploreSchedule> schedule_;
  // The simulation of the replay; null if the recording has a schedule, because prepared_ then owns
  // the simulation.
  std::unique_ptr<Simulation> own_simulation_;
  Simulation* simulation_ = nullptr;
  std::string only_;
  uint64_t answer_count_ = 0;
  std::vector<AnswerDifference> answer_differences_;
  TraceEntry last_;
  int64_t length_us_ = 0;
  uint64_t count_ = 0;
  bool at_end_ = false;
  std::string difference_;
  std::string loss_;
};

}  // namespace openr_host
