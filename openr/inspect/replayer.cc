#include "openr/inspect/replayer.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "cli/counted.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "openr/decode/decode_message.h"
#include "openr/inspect/recorded_network.h"
#include "openr/inspect/trace_text.h"
#include "openr/simulation/run_stick.h"
#include "openr/simulation/sanitizer_start.h"
#include "runtime/base/spelling.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

using Kind = TraceEntry::Kind;

// Returns `said`, the content of a message in words, for the end of a line: ": " and then `said`,
// put on one line and shortened (OneLineOf()).  Returns "" if `said` is "".
std::string AfterColon(const std::string& said) {
  return said.empty() ? "" : ": " + OneLineOf(said);
}

// Returns a text with the first value that differs between `now`, the content of a message, and
// `then`, its recorded content, and with the number of further values that differ.  Returns "" if
// the sizes differ, or if no value differs when the contents are converted to words.
std::string ValuesThatDiffer(const RobotModel& model, const std::string& entry,
                             const std::string& now, const std::string& then) {
  if (now.size() != then.size()) return "";
  const AnswerDifference values = CompareAnswer(model, entry, now, then);
  if (values.now.empty()) return "";
  std::string text = fmt::format(": '{}' now, '{}' when recorded", OneLineOf(values.now[0]),
                                 OneLineOf(values.then[0]));
  if (values.now.size() > 1) text += ", and " + Counted(values.now.size() - 1, "more value");
  return text;
}

}  // namespace

void StartWithSanitizerOfRecording(const ReplayOptions& options) {
  const TraceReader reader(options.file);
  StartWithSanitizerOf(options.stick.empty() ? reader.header().stick : options.stick);
  for (const std::string& stick : reader.header().more_sticks) StartWithSanitizerOf(stick);
}

SimulationOptions Replayer::OptionsOf(const TraceHeader& header, const ReplayOptions& replay) {
  SimulationOptions options;
  options.stick = replay.stick.empty() ? header.stick : replay.stick;
  options.writable_stick = !header.write_protected;
  options.robot = header.robot;
  options.body = header.body;
  options.world = header.world;
  options.cost_file = header.cost;
  options.battery = header.battery;
  options.microphone = header.microphone;
  options.images = header.images;
  for (const std::string& text : header.addresses) {
    AddressPair pair;
    if (ParseAddressPair(text, &pair).empty()) options.addresses.push_back(pair);
  }
  options.robots = header.robots;
  options.together = header.together;
  options.more_sticks = header.more_sticks;
  options.seed = header.seed;
  options.strict = header.strict;
  options.host_network = false;
  options.console = replay.console;
  return options;
}

// Makes a copy of the Memory Stick with its content at the beginning of the recorded run: copies
// the folder `now`, then undoes the recorded `changes` in the copy, the last one first.  Returns
// the folder of the copy.
std::string Replayer::RestoreStick(const std::string& now, const std::vector<TraceEntry>& changes) {
  namespace fs = std::filesystem;
  const fs::path stick = fs::path(folder_.path()) / "stick";
  fs::create_directory(stick);
  CopyStick(now, stick);
  for (auto change = changes.rbegin(); change != changes.rend(); ++change) {
    const fs::path path = (stick / change->name).lexically_normal();
    if (!path.string().starts_with(stick.string() + "/"))
      throw std::runtime_error(fmt::format("{}: '{}' is not on the stick", file_, change->name));
    if (change->what == TraceEntry::PathKind::kFolder) {
      fs::create_directories(path);
      continue;
    }
    fs::remove_all(path);
    if (change->what != TraceEntry::PathKind::kFile) continue;
    const std::string problem = WriteFile(path, change->payload);
    if (!problem.empty()) throw std::runtime_error(problem);
  }
  return stick;
}

// Makes the simulation of the replay.  If the recording has a schedule, the simulation delivers
// messages in the order of this schedule.
void Replayer::MakeRun(SimulationOptions options) {
  const std::string& text = reader_.header().schedule;
  if (text.empty()) {
    own_simulation_ = std::make_unique<Simulation>(options);
    simulation_ = own_simulation_.get();
    return;
  }
  const auto json = ParseJson<nlohmann::ordered_json>(text);
  options.guard_regions = json.at("guard");
  prepared_ = PrepareSimulation(options);
  if (!prepared_.problem.empty()) throw std::runtime_error(prepared_.problem);
  simulation_ = prepared_.simulation;
  std::vector<Deviation> deviations;
  for (const auto& line : json.at("deviations"))
    deviations.push_back(DeviationFromJson(line, *prepared_.system));
  schedule_ = std::make_unique<ScriptedSchedule>(*prepared_.system, deviations);
  SetSchedule(&prepared_, json.at("seed"), schedule_.get(), json.at("for_us"));
}

Replayer::Replayer(const ReplayOptions& replay) : file_(replay.file), reader_(replay.file) {
  if (reader_.header().is_free) {
    throw std::runtime_error(fmt::format(
        "{}: a free run (--free-running) cannot be replayed: the wall clock decided when "
        "handlers ended; openr trace shows what happened",
        file_));
  }
  // Reads the changes of the stick from the whole recording before it makes the simulation, because
  // the simulation needs the stick with its content at the beginning of the recorded run.
  std::vector<TraceEntry> changes;  // recorded changes of the Memory Stick
  for (TraceReader reader(file_); reader.Peek() != nullptr;) {
    TraceEntry entry = reader.Take();
    const int64_t time_us = entry.kind == Kind::kMessage ? entry.record.time_us : entry.time_us;
    length_us_ = std::max(length_us_, time_us);
    if (entry.kind == Kind::kStick) changes.push_back(std::move(entry));
  }
  SimulationOptions options = OptionsOf(reader_.header(), replay);
  const std::string stick = options.stick;
  if (options.robots == 1) {  // several robots can only read their sticks, so these need no copy
    if (std::error_code error; !std::filesystem::is_directory(stick, error)) {
      throw std::runtime_error(
          fmt::format("{}: the stick {} is no longer there; give it with --stick", file_, stick));
    }
    options.stick = RestoreStick(stick, changes);
  }
  options.network_filter = [this](int robot, std::unique_ptr<Network>) {
    return std::make_unique<ReplayedNetwork>([this, robot] { return NextNetworkEvents(robot); });
  };
  if (replay.prepare) replay.prepare(&options);
  MakeRun(options);
  if (system().robot(0).stick_hash != reader_.header().stick_hash) {
    throw std::runtime_error(
        fmt::format("{}: was recorded with other files on the stick than {} has now; give the "
                    "stick of then with --stick",
                    file_, stick));
  }
  const std::vector<uint64_t>& hashes = reader_.header().more_stick_hashes;
  for (size_t i = 0; i < hashes.size(); ++i) {
    if (system().robot(static_cast<int>(i) + 1).stick_hash == hashes[i]) continue;
    throw std::runtime_error(fmt::format(
        "{}: was recorded with other files on the stick of robot {} than {} has now; put the "
        "files of then back there",
        file_, i + 1, options.more_sticks[i]));
  }
  if (!replay.only.empty()) only_ = FindOnly(replay.only);
  if (replay.begin) replay.begin(simulation_, options, changes);
  system().trace().AddSink(
      [this](const TraceRecord& record, const Message& message) { Compare(record, message); });
  system().Boot();
}

Replayer::~Replayer() = default;

// Returns the name of the object of robot 0 that the user has named as `name`.  Throws
// std::runtime_error if there is no such object.
std::string Replayer::FindOnly(const std::string& name) {
  std::vector<std::string> known;
  for (const auto& object : system().objects()) {
    if (object->robot == 0) known.push_back(object->name);
  }
  const std::optional<std::string> match = MatchIgnoringCase(name, known);
  if (match) return *match;
  throw std::runtime_error(
      fmt::format("{}: there is no object '{}'{}", file_, name, DidYouMean(name, known)));
}

void Replayer::SkipNames() {
  for (const TraceEntry* next = reader_.Peek();
       next != nullptr && (next->kind == Kind::kObject || next->kind == Kind::kEntry ||
                           next->kind == Kind::kStick || next->kind == Kind::kEnded);
       next = reader_.Peek()) {
    reader_.Take();
  }
}

std::vector<NetworkEvent> Replayer::NextNetworkEvents(int robot) {
  const TraceEntry* const next = reader_.Peek();
  if (next == nullptr || next->kind != Kind::kNetwork || next->robot != robot) return {};
  return reader_.Take().events;
}

std::string Replayer::EntryOf(const TraceEntry& message) const {
  return reader_.EntryName(message.record.target, message.record.selector);
}

void Replayer::Differ(const TraceEntry& recorded, const std::string& what) {
  const TraceRecord& r = recorded.record;
  const std::string entry = EntryOf(recorded);
  const std::string said =
      recorded.payload.empty() ? "" : DecodeContent(simulation_->model(), entry, recorded.payload);
  difference_ = fmt::format("message {} (t={:.6f} s, {} -> {} \"{}\"{}): {}", r.number,
                            Seconds(r.time_us), reader_.ObjectName(r.sender),
                            reader_.ObjectName(r.target), entry, AfterColon(said), what);
}

void Replayer::CompareFields(const TraceEntry& recorded, const TraceRecord& now,
                             const Message& message) {
  const TraceRecord& then = recorded.record;
  const auto name = [&](ObjectId id) {
    const Object* const object = system().object(id);
    return object == nullptr ? std::string("(system)") : object->name;
  };
  if (now.number != then.number) {
    Differ(recorded,
           fmt::format("now it is message {} to {} \"{}\" that comes here{}", now.number,
                       name(now.target), system().object(now.target)->EntryName(now.selector),
                       AfterColon(DecodeHandled(system(), message))));
  } else if (now.time_us != then.time_us) {
    Differ(recorded, fmt::format("is delivered at t={:.6f} s now", Seconds(now.time_us)));
  } else if (now.target != then.target || now.selector != then.selector) {
    Differ(recorded, fmt::format("goes to {} \"{}\" now", name(now.target),
                                 system().object(now.target)->EntryName(now.selector)));
  } else if (now.sender != then.sender) {
    Differ(recorded, fmt::format("comes from {} now", name(now.sender)));
  } else if (now.cause != then.cause) {
    Differ(recorded,
           fmt::format("is caused by message {} now, by {} when recorded", now.cause, then.cause));
  } else if (now.size != then.size) {
    // Compares the sizes of messages of the object `only_`, too, although their content may differ
    // from the recording.  The replay gives such a message the recorded bytes, for which it must
    // have the recorded size.
    Differ(recorded, fmt::format("has {} bytes now, {} when recorded", now.size, then.size));
  }
}

bool Replayer::IsAnswer(const TraceRecord& record) const {
  if (only_.empty()) return false;
  const Object* const sender = simulation_->system().object(record.sender);
  return sender != nullptr && sender->name == only_;
}

// Compares a message that the object `only_` has sent with the recording.  Then gives the message
// the recorded bytes, so that the other objects get what they got in the recorded run.
void Replayer::CompareAnswerOf(const Message& message, const TraceRecord& record) {
  ++answer_count_;
  const std::string now = PayloadBytes(message);
  const bool has_bytes = reader_.header().payloads && (message.kind == PayloadKind::kBytes ||
                                                       message.kind == PayloadKind::kNotify);
  if (record.payload_hash == last_.record.payload_hash) return;
  if (!has_bytes || now.size() != last_.payload.size())
    return Differ(last_, "its content differs now, and the others cannot get the recorded one");
  const std::string entry = system().object(record.target)->EntryName(record.selector);
  AnswerDifference difference = CompareAnswer(simulation_->model(), entry, now, last_.payload);
  difference.record = record;
  difference.receiver = system().object(record.target)->name;
  difference.entry = entry;
  answer_differences_.push_back(std::move(difference));
  PutContent(message, last_.payload);
}

void Replayer::ComparePayload(const TraceEntry& recorded, const Message& message, uint64_t hash) {
  if (!reader_.header().payloads) return;
  const std::string now = ContentOf(message);
  const std::string& then = recorded.payload;
  // The content of a message of the network stack is a description.  Only the hash decides whether
  // such messages are equal, because another version of this program may describe them in other
  // words, and an older version has recorded no description.
  if (message.kind == PayloadKind::kHashed) {
    if (hash != recorded.record.payload_hash && !then.empty() && now != then)
      Differ(recorded, fmt::format("is '{}' now, '{}' when recorded", now, then));
    return;
  }
  const size_t common = std::min(now.size(), then.size());
  const size_t at = static_cast<size_t>(
      std::mismatch(now.begin(), now.begin() + static_cast<ptrdiff_t>(common), then.begin()).first -
      now.begin());
  if (at < common) {
    Differ(recorded,
           fmt::format("byte {} of {} is 0x{:02x} now, 0x{:02x} when recorded{}", at, now.size(),
                       static_cast<uint8_t>(now[at]), static_cast<uint8_t>(then[at]),
                       ValuesThatDiffer(simulation_->model(), EntryOf(recorded), now, then)));
  } else if (now.size() != then.size()) {
    Differ(recorded, fmt::format("has {} bytes now, {} when recorded", now.size(), then.size()));
  }
}

void Replayer::Compare(const TraceRecord& record, const Message& message) {
  if (!difference_.empty() || at_end_) return;
  SkipNames();
  const TraceEntry* const next = reader_.Peek();
  const bool is_end = next != nullptr && next->kind == Kind::kEnd;
  if (next == nullptr || (is_end && record.time_us >= next->time_us)) {
    // Ends the replay here, and does not count the message as a difference: the recorded run may
    // have stopped between two messages of the same time, so the recording may lack a message of
    // this time.
    at_end_ = true;
    return;
  }
  if (is_end) return DifferAfterLast(record, message, next->time_us);
  if (next->kind == Kind::kLoss) return EndAtLoss();
  if (next->kind != Kind::kMessage) {
    difference_ = fmt::format(
        "after message {}: the recording has input here, the run has "
        "{} now",
        last_.record.number, MessageText(record.number, DecodeHandled(system(), message)));
    return;
  }
  last_ = reader_.Take();
  CompareFields(last_, record, message);
  if (difference_.empty() && IsAnswer(record)) {
    CompareAnswerOf(message, record);
    if (difference_.empty()) ++count_;
    return;
  }
  if (difference_.empty()) ComparePayload(last_, message, record.payload_hash);
  if (difference_.empty() && record.payload_hash != last_.record.payload_hash)
    Differ(last_, "its bytes have another hash now");
  if (difference_.empty()) ++count_;
}

// Reports `message`, which is delivered although the recorded run had no more messages before its
// end at `end_us`.
void Replayer::DifferAfterLast(const TraceRecord& record, const Message& message, int64_t end_us) {
  difference_ = fmt::format(
      "after message {}: the recording has no further message before its end at t={:.6f} s, the "
      "run "
      "has {} at t={:.6f} s now",
      last_.record.number, Seconds(end_us),
      MessageText(record.number, DecodeHandled(system(), message)), Seconds(record.time_us));
}

// Ends the replay where a worker process of the recorded run was lost, that is, crashed or answered
// no more.  This may have interrupted a handler anywhere in its code, so what happened afterwards
// cannot be repeated.
void Replayer::EndAtLoss() {
  at_end_ = true;
  loss_ = fmt::format(
      "{}: after message {} process '{}' was lost; what came then cannot be replayed, "
      "openr trace shows it",
      file_, last_.record.number, reader_.Take().name);
}

void Replayer::CompareEnd(const TraceEntry& end) {
  at_end_ = true;
  // Runs until the recorded end, because the recorded state hash is of that time.  When the robots
  // are off, the replay may have no message at that time.  Then delivering messages alone does not
  // bring the clock to that time.
  if (system().now_us() < end.time_us) system().RunUntil(end.time_us);
  // Does not compare the hashes of messages and state if a message differs, because the hashes then
  // differ, too.
  if (!difference_.empty() || !answer_differences_.empty()) return;
  if (system().trace_hash() != end.trace_hash) {
    difference_ = fmt::format("at the end: trace hash {:016x} now, {:016x} when recorded",
                              system().trace_hash(), end.trace_hash);
  } else if (system().state_hash() != end.state_hash) {
    difference_ = fmt::format("at the end: state hash {:016x} now, {:016x} when recorded",
                              system().state_hash(), end.state_hash);
  }
}

// Handles the next entry of the recording if it is neither a message nor network input.  Applies a
// recorded input, such as "press pause", if its time has come.  At the end of the recording,
// compares the hashes of this run's messages and state with the recorded hashes.  Where a worker
// process was lost, ends the replay.  Returns true only after it has applied an input.
bool Replayer::ApplyInput() {
  SkipNames();
  const TraceEntry* const next = reader_.Peek();
  if (next == nullptr) {
    at_end_ = true;
    return false;
  }
  if (next->kind == Kind::kEnd) {
    if (next->time_us <= system().now_us() || system().powered_off()) CompareEnd(reader_.Take());
    return false;
  }
  // Leaves messages and network input to other functions: Compare() handles a message when it is
  // delivered, NextNetworkEvents() handles network input when a robot polls its network.
  if (next->kind == Kind::kMessage || next->kind == Kind::kNetwork) return false;
  if (next->time_us > system().now_us()) return false;
  if (next->kind == Kind::kLoss) {
    EndAtLoss();
    return false;
  }
  const TraceEntry input = reader_.Take();
  // A robot number below 0 stands for all robots.  A pause and a shutdown in an old recording have
  // such a number, because the recording does not say for which robot they are (trace_coder.cc).
  const bool is_for_all = input.robot < 0;
  const int first = is_for_all ? 0 : input.robot;
  const int end = is_for_all ? system().robot_count() : first + 1;
  for (int robot = first; robot < end; ++robot) {
    const std::string problem = system().inputs().Add(robot, input.name);
    if (problem.empty()) continue;
    difference_ = fmt::format("after message {}: the input '{}' is refused now: {}{}",
                              last_.record.number, OneLineOf(input.name), problem,
                              input.name.size() > ConsoleInput::kUnreadMax
                                  ? "; an older openr has recorded the run, which had no such "
                                    "limit: replay it with that one, or record the run again"
                                  : "");
    return false;
  }
  return true;
}

std::optional<uint64_t> Replayer::CountUpTo(uint64_t number) const {
  uint64_t count = 0;
  for (TraceReader reader(file_); reader.Peek() != nullptr;) {
    const TraceEntry entry = reader.Take();
    count += entry.kind == Kind::kMessage;
    if (entry.kind == Kind::kMessage && entry.record.number == number) return count;
  }
  return {};
}

int64_t Replayer::NextTimeUs() {
  SkipNames();
  const TraceEntry* const next = reader_.Peek();
  if (next == nullptr) return INT64_MAX;
  if (next->kind == Kind::kMessage) return next->record.time_us;
  return next->kind == Kind::kNetwork ? system().now_us() : next->time_us;
}

bool Replayer::Step() {
  while (ApplyInput()) {
  }
  if (at_end_ || !difference_.empty()) return false;
  const int64_t next_us = NextTimeUs();
  if (next_us == INT64_MAX) {
    at_end_ = true;
    return false;
  }
  const uint64_t before = count_;
  system().RunOne(std::max(next_us, system().now_us()));
  if (!difference_.empty()) return false;
  if (count_ != before || at_end_) return true;
  // Looks at the next entry of the recording, because RunOne() has delivered no message up to the
  // time of this entry.  If the entry is input, the next Step() applies it.  If the entry is a
  // message, the replay differs from the recording, because the message has not come.
  const TraceEntry* const next = reader_.Peek();
  if (next == nullptr || next->kind != Kind::kMessage) return true;
  const TraceEntry missing = *next;
  Differ(missing, "does not come now");
  return false;
}

void Replayer::RunOne(int64_t time_us) {
  // Applies all due inputs first, because NextTimeUs() would otherwise return the time of such an
  // input instead of the time of the entry after it.
  while (ApplyInput()) {
  }
  if (!EndReason().empty()) return;
  const int64_t next_us = NextTimeUs();
  if (next_us <= time_us || next_us == INT64_MAX) {
    Step();
  } else {
    system().RunUntil(time_us);  // the recording has nothing up to this time
  }
}

std::string Replayer::EndReason() const {
  if (!difference_.empty()) return "the run differs from the recording here: " + difference_;
  if (!loss_.empty()) return loss_;
  return at_end_ ? "the recording is over" : "";
}

}  // namespace openr_host
