#include "openr/explore/explore_schedule.h"

#include <OPENR/ODataFormats.h>

#include <algorithm>
#include <utility>

#include "runtime/core/system.h"
#include "runtime/ipstack/ip_stack.h"

namespace openr_host {
namespace {

// Largest delays of messages inside the robot; each seed uses one of these three.  The largest
// delay is realistic: on a real robot the longest gap between two sensor vectors was almost 188 ms
// instead of the usual 32 ms, so a vector was about 150 ms late (docs/exploring.md).  The smaller
// delays disturb a run less.
constexpr int64_t kDelayMaxUs[] = {2'000, 20'000, 150'000};

// Largest delay of messages from the network, in frames of 8 ms: 200 ms.  On the robot under load,
// received data reached an object in steps of about 200 ms (field-notes.md, 11.6).
constexpr int64_t kNetworkFramesMax = 25;

// Number of different faults from which a seed chooses.  No document gives it; it is our choice.
constexpr uint64_t kFaultNumbers = 1'000'000;

}  // namespace

ExploreSchedule::ExploreSchedule(const System& system)
    : system_(system),
      last_due_us_(system.objects().size(), 0),
      is_network_(system.objects().size(), -1) {}

void ExploreSchedule::Record(Deviation deviation, int64_t us) {
  deviation.us = us;
  deviations_.push_back(deviation);
  if (log_ != nullptr && log_->count < DeviationLog::kMax) {
    log_->entries[log_->count] = deviation;
    ++log_->count;
  }
}

size_t ExploreSchedule::Choose(Question question, const std::vector<ObjectId>& candidates) {
  Deviation spot;
  if (question == Question::kStart) {
    spot.kind = Deviation::Kind::kStart;
    spot.nth = start_count_++;
  } else {
    const int64_t now_us = system_.now_us();
    if (std::exchange(tie_time_us_, now_us) != now_us) tie_count_ = 0;
    spot.kind = Deviation::Kind::kTie;
    spot.time_us = now_us;
    spot.nth = tie_count_++;
  }
  const size_t chosen = PickOf(spot, candidates);
  if (chosen != 0) {
    spot.object = candidates[chosen];
    Record(spot, 0);
  }
  return chosen;
}

bool ExploreSchedule::IsNetwork(ObjectId id) {
  int8_t& known = is_network_.at(static_cast<size_t>(id));
  if (known < 0) known = system_.object(id)->name == IpStack::kName;
  return known != 0;
}

// Returns the time by which `message` is delayed.  Messages to one object keep the order of
// sending, as in the robot's queues, so a delay of one message also delays the messages behind it.
// Three kinds of messages are never delayed (docs/exploring.md): answers to Call(), messages to
// which the sender has given a delay, and messages to system objects.
int64_t ExploreSchedule::ExtraDelayUs(const Message& message, int64_t now_us, int64_t delay_us) {
  OnPost(message);
  if (message.is_reply || delay_us != 0 || system_.object(message.target)->is_system()) return 0;
  const bool of_its_own = message.sender == kNoObject || message.sender == message.target;
  const bool from_network = !of_its_own && IsNetwork(message.sender);
  int64_t due_us = now_us;
  int64_t* last_due_us = &last_due_us_.at(static_cast<size_t>(message.target));
  if (!of_its_own && message.reply_box == 0) {
    Stream* const stream = &streams_[{message.sender, message.target, message.selector}];
    due_us += PickedDelayUs(message, stream, from_network);
    // Lets data from the network wait only for earlier data from the same sender to the same
    // handler, so that late data do not hold up messages of other objects.
    if (from_network) last_due_us = &stream->last_due_us;
  }
  due_us = std::max(due_us, *last_due_us);
  *last_due_us = due_us;
  return due_us - now_us;
}

int64_t ExploreSchedule::PickedDelayUs(const Message& message, Stream* stream, bool from_network) {
  Deviation spot;
  spot.kind = Deviation::Kind::kDelay;
  spot.time_us = system_.now_us();
  spot.nth = stream->count++;
  spot.object = message.target;
  spot.sender = message.sender;
  spot.selector = message.selector;
  const int64_t us = PickDelayUs(spot, from_network);
  if (us != 0) Record(spot, us);
  return us;
}

int64_t ExploreSchedule::CostJitterUs(const Object& object, uint32_t selector, int64_t range_us) {
  Deviation spot;
  spot.kind = Deviation::Kind::kCost;
  spot.time_us = system_.now_us();
  spot.nth = calls_[{object.id, selector}]++;
  spot.object = object.id;
  spot.selector = selector;
  const int64_t us = std::clamp(PickCostUs(spot, range_us), -range_us, range_us);
  if (us != 0) Record(spot, us);
  return us;
}

int64_t ExploreSchedule::FirstFrame(int robot, int64_t frames) {
  Deviation spot;
  spot.kind = Deviation::Kind::kFrame;
  spot.nth = static_cast<uint64_t>(robot);
  const int64_t frame = PickFrame(spot, frames);
  if (frame != 0) Record(spot, frame);
  return frame;
}

std::vector<Deviation> ExploreSchedule::Faults(int robots, int64_t for_us) {
  std::vector<Deviation> faults = PickFaults(robots, for_us);
  for (const Deviation& fault : faults) Record(fault, fault.us);
  return faults;
}

RandomSchedule::RandomSchedule(const System& system, uint64_t seed, const ScheduleChoices& vary)
    : ExploreSchedule(system),
      order_(seed, "explore/order"),
      delay_(seed, "explore/delay"),
      cost_(seed, "explore/cost"),
      frame_(seed, "explore/frame"),
      fault_(seed, "explore/fault") {
  // Leaves the frequency of all kinds of deviations at 0 for the default seed, which stands for the
  // canonical order.
  if (seed == SystemOptions().seed) return;
  Rng temper(seed, "explore/temper");
  const auto one_of = [&temper](auto... rates) {
    const double all[] = {static_cast<double>(rates)...};
    return all[temper.NextBelow(sizeof...(rates))];
  };
  // Draws values also for those kinds of choices that `vary` switches off.  So switching one kind
  // off does not change the values of the other kinds.
  const double start = one_of(0, 1, 1), tie = one_of(0.02, 0.3, 1);
  const double delay = one_of(0, 0.002, 0.03), network = one_of(0, 0.1, 0.5);
  const double cost = one_of(0, 0.05, 1), frame = one_of(0, 0, 0, 1);
  delay_max_us_ = kDelayMaxUs[temper.NextBelow(std::size(kDelayMaxUs))];
  // Draws the number of the object whose messages are often delayed.  Draws from three times as
  // many numbers as there are objects.  So with two thirds of the seeds, no object has this number,
  // and the messages of all objects are delayed equally often.
  const uint64_t slow = temper.NextBelow(3 * system.objects().size());
  if (vary.starts) start_rate_ = start;
  if (vary.ties) tie_rate_ = tie;
  if (vary.delays) delay_rate_ = delay;
  if (vary.delays && slow < system.objects().size()) slow_ = static_cast<ObjectId>(slow);
  if (vary.network) network_rate_ = network;
  if (vary.costs) cost_rate_ = cost;
  if (vary.frames) frame_rate_ = frame;
  fault_count_ = vary.faults;
}

size_t RandomSchedule::PickOf(const Deviation& spot, const std::vector<ObjectId>& candidates) {
  const double rate = spot.kind == Deviation::Kind::kStart ? start_rate_ : tie_rate_;
  return Happens(&order_, rate) ? order_.NextBelow(candidates.size()) : 0;
}

int64_t RandomSchedule::PickDelayUs(const Deviation& spot, bool from_network) {
  if (from_network) {
    if (!Happens(&delay_, network_rate_)) return 0;
    return kFrameUs * static_cast<int64_t>(delay_.NextBelow(kNetworkFramesMax + 1));
  }
  if (!Happens(&delay_, spot.object == slow_ ? 0.5 : delay_rate_)) return 0;
  return 1 + static_cast<int64_t>(delay_.NextBelow(static_cast<uint64_t>(delay_max_us_)));
}

int64_t RandomSchedule::PickCostUs(const Deviation&, int64_t range_us) {
  if (!Happens(&cost_, cost_rate_)) return 0;
  return static_cast<int64_t>(cost_.NextBelow(static_cast<uint64_t>(2 * range_us + 1))) - range_us;
}

// Picks the number of the robot's first frame: 0, or a number so large that the frame counter
// begins again at 0 within the run of `frames` frames.  A real robot comes to the end of the
// counter only after weeks, so this case is seldom tested on a real robot.
int64_t RandomSchedule::PickFrame(const Deviation&, int64_t frames) {
  if (frames <= 1 || !Happens(&frame_, frame_rate_)) return 0;
  return int64_t{oframeMAX_NUMBER} -
         static_cast<int64_t>(frame_.NextBelow(static_cast<uint64_t>(frames)));
}

std::vector<Deviation> RandomSchedule::PickFaults(int robots, int64_t for_us) {
  std::vector<Deviation> faults;
  const int64_t frames = for_us / kFrameUs;
  if (robots == 0 || frames == 0) return faults;
  for (int i = 0; i < fault_count_; ++i) {
    Deviation fault;
    fault.kind = Deviation::Kind::kFault;
    fault.time_us =
        kFrameUs * (1 + static_cast<int64_t>(fault_.NextBelow(static_cast<uint64_t>(frames))));
    fault.selector = static_cast<uint32_t>(fault_.NextBelow(static_cast<uint64_t>(robots)));
    fault.us = static_cast<int64_t>(fault_.NextBelow(kFaultNumbers));
    faults.push_back(fault);
  }
  std::stable_sort(faults.begin(), faults.end(),
                   [](const Deviation& a, const Deviation& b) { return a.time_us < b.time_us; });
  for (size_t i = 0; i < faults.size(); ++i) faults[i].nth = i;
  return faults;
}

ScriptedSchedule::ScriptedSchedule(const System& system, const std::vector<Deviation>& script)
    : ExploreSchedule(system) {
  for (const Deviation& deviation : script) script_[SpotOf(deviation)] = deviation;
}

ScriptedSchedule::Spot ScriptedSchedule::SpotOf(const Deviation& deviation) {
  using Kind = Deviation::Kind;
  const Kind kind = deviation.kind;
  const bool of_entry = kind == Kind::kDelay || kind == Kind::kCost;
  // Uses the time to find a deviation only for kTie, which orders messages of the same time.
  // Another deviation is found by the number of its message or call (nth), because its time changes
  // when other deviations are removed, and this number does not.
  return {kind,
          kind == Kind::kTie ? deviation.time_us : 0,
          deviation.nth,
          of_entry ? deviation.object : kNoObject,
          kind == Kind::kDelay ? deviation.sender : kNoObject,
          of_entry ? deviation.selector : 0};
}

const Deviation* ScriptedSchedule::Find(const Deviation& spot) const {
  const auto found = script_.find(SpotOf(spot));
  return found == script_.end() ? nullptr : &found->second;
}

size_t ScriptedSchedule::PickOf(const Deviation& spot, const std::vector<ObjectId>& candidates) {
  const Deviation* const deviation = Find(spot);
  if (deviation == nullptr) return 0;
  const auto found = std::find(candidates.begin(), candidates.end(), deviation->object);
  return found == candidates.end() ? 0 : static_cast<size_t>(found - candidates.begin());
}

int64_t ScriptedSchedule::PickDelayUs(const Deviation& spot, bool) {
  const Deviation* const deviation = Find(spot);
  return deviation == nullptr ? 0 : std::max<int64_t>(deviation->us, 0);
}

int64_t ScriptedSchedule::PickCostUs(const Deviation& spot, int64_t) {
  const Deviation* const deviation = Find(spot);
  return deviation == nullptr ? 0 : deviation->us;
}

int64_t ScriptedSchedule::PickFrame(const Deviation& spot, int64_t) {
  const Deviation* const deviation = Find(spot);
  return deviation == nullptr ? 0 : std::max<int64_t>(deviation->us, 0);
}

std::vector<Deviation> ScriptedSchedule::PickFaults(int, int64_t) {
  std::vector<Deviation> faults;
  for (const auto& [spot, deviation] : script_) {
    if (deviation.kind == Deviation::Kind::kFault) faults.push_back(deviation);
  }
  std::stable_sort(faults.begin(), faults.end(),
                   [](const Deviation& a, const Deviation& b) { return a.time_us < b.time_us; });
  return faults;
}

}  // namespace openr_host
