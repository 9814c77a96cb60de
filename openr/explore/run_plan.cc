#include "openr/explore/run_plan.h"

#include <fmt/format.h>

#include <deque>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "openr/decode/decode_message.h"
#include "openr/ending/ending.h"
#include "openr/explore/exact_schedule.h"
#include "openr/explore/explore_cost.h"
#include "openr/simulation/activity.h"
#include "runtime/core/stalls.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

std::unique_ptr<ExploreSchedule> ScheduleOf(const Json& plan, const System& system,
                                            const ScheduleChoices& vary) {
  if (plan.contains("exact")) return std::make_unique<ExactSchedule>(system, plan["exact"]);
  if (!plan.contains("script")) {
    return std::make_unique<RandomSchedule>(system, plan.at("seed").get<uint64_t>(), vary);
  }
  std::vector<Deviation> script;
  for (const Json& line : plan["script"]) script.push_back(DeviationFromJson(line, system));
  return std::make_unique<ScriptedSchedule>(system, script);
}

class PlanRun {
 public:
  PlanRun(PreparedRun* prepared, const Json& plan, const RunOptions& options, DeviationLog* log)
      : prepared_(*prepared),
        system_(*prepared->system),
        plan_(plan),
        for_us_(options.for_us),
        until_us_(plan.value("until_us", options.for_us)),
        slice_us_(plan.value("slice_us", kFrameUs)),
        tail_max_(plan.value("tail", size_t{0})),
        schedule_(ScheduleOf(plan, system_, options.vary)),
        exact_(dynamic_cast<ExactSchedule*>(schedule_.get())) {
    if (!plan.value("blind", false)) properties_ = options.properties.Make();
    for (const VirtualRobot* robot : prepared_.robots) standing_.emplace_back(robot->model());
    view_ = {&prepared_, &standing_, 0};
    schedule_->set_log(log);
  }

  // Returns the answer (the JSON that describes the result of a run) for a run in which an object
  // has ended the process: the object has crashed, or its handler has not returned.
  Json AnswerForEnding(const Ending& ending) {
    std::string_view text = ending.record.text();
    while (text.ends_with('\n')) text.remove_suffix(1);
    broken_ = nullptr;
    const char* const ended_by = EndName(ending.kind);
    Break(PropertyOfEnding(ended_by), std::string(text));
    Json answer = {{"seed", plan_.at("seed")}, {"ended_by", ended_by}};
    AddBroken(&answer);
    return answer;
  }

  Json Run() {
    // Passes `for_us_`, the length of a full run, and not `until_us_`, at which this run may end
    // earlier.  The first frame and the faults depend on the passed length, so this run makes the
    // same choices as a full run.
    SetSchedule(&prepared_, plan_.at("seed").get<uint64_t>(), schedule_.get(), for_us_);
    const int sink = system_.trace().AddSink(
        [this](const TraceRecord& record, const Message& message) { OnDelivery(record, message); });
    system_.Boot();
    while (system_.now_us() < until_us_ && !system_.powered_off() && broken_.is_null()) {
      RunTo(std::min(system_.now_us() + slice_us_, until_us_));
      if (WasCut()) break;
      CheckProperties();
    }
    system_.trace().RemoveSink(sink);
    if (broken_.is_null() && !WasCut()) CheckPropertiesAtEnd();
    return Answer();
  }

 private:
  // A delivered message.  The last such messages become a part of the answer, which describes the
  // result of the run.
  struct SeenRecord {
    TraceRecord record;
    std::string content;  // content of the message, from ContentOf(), cut to kDecodedBytesMax bytes
  };

  void OnDelivery(const TraceRecord& record, const Message& message) {
    last_message_ = record.number;
    if (IsActivity(system_, message)) view_.last_activity_us = record.time_us;
    if (exact_ != nullptr) exact_->OnDelivery(message);
    if (tail_max_ == 0) return;
    tail_.push_back({record, ContentOf(message).substr(0, kDecodedBytesMax)});
    if (tail_.size() > tail_max_) tail_.pop_front();
  }

  bool WasCut() const { return exact_ != nullptr && exact_->is_cut(); }

  void RunTo(int64_t time_us) {
    if (exact_ == nullptr) {
      system_.RunUntil(time_us);
    } else {
      system_.RunUntil([this] { return exact_->is_cut(); }, time_us - system_.now_us());
    }
  }

  void CheckProperties() {
    if (properties_.empty()) return;
    for (size_t i = 0; i < standing_.size(); ++i) {
      standing_[i].Sample(prepared_.robots[i]->body().state(), system_.now_us());
    }
    for (const auto& property : properties_) {
      if (broken_.is_null()) Break(property->name(), property->Check(view_));
    }
  }

  void CheckPropertiesAtEnd() {
    for (const auto& property : properties_) {
      if (broken_.is_null()) Break(property->name(), property->CheckEnd(view_));
    }
  }

  void Break(const std::string& property, const std::string& text) {
    if (text.empty()) return;
    broken_ = {{"property", property},
               {"time_us", system_.now_us()},
               {"message", last_message_},
               {"text", text}};
  }

  std::string Describe(const SeenRecord& seen) const {
    const TraceRecord& record = seen.record;
    const Object* const sender = system_.object(record.sender);
    const Object* const target = system_.object(record.target);
    const std::string content =
        OneLineOf(DecodeReceived(system_, record.target, record.selector, seen.content));
    return fmt::format("t={:.6f} s  message {} (cause {})  {} -> {}  {}{}{}",
                       static_cast<double>(record.time_us) * 1e-6, record.number, record.cause,
                       sender == nullptr ? "outside" : sender->name, target->name,
                       target->EntryName(record.selector), content.empty() ? "" : ": ", content);
  }

  void CountFindings(Json* answer) const {
    uint64_t errors = 0, warnings = 0;
    for (const Finding& finding : system_.findings().all()) {
      errors += finding.severity == Severity::kError;
      warnings += finding.severity == Severity::kWarning;
    }
    (*answer)["warnings"] = warnings;
    (*answer)["errors"] = errors;
  }

  Json Answer() {
    Json answer = {{"seed", plan_.at("seed")},
                   {"time_us", system_.now_us()},
                   {"ended_by", EndKindName()},
                   {"messages", system_.message_count()},
                   {"state", fmt::format("{:016x}", system_.state_hash())},
                   {"trace", fmt::format("{:016x}", system_.trace_hash())}};
    CountFindings(&answer);
    AddBroken(&answer);
    if (exact_ != nullptr) answer["exact"] = exact_->Result();
    return answer;
  }

  const char* EndKindName() const {
    if (system_.end()) return EndName(system_.end()->kind);
    return broken_.is_null() ? EndName(EndKind::kTime) : "property";
  }

  // Adds to the answer `to` the fields that explain a broken property (run_plan.h): the property
  // itself, the deviations, the objects that wait, and the last messages.  The field "broken" is
  // null if the run has broken no property.
  void AddBroken(Json* to) const {
    Json& answer = *to;
    answer["broken"] = broken_;
    if (!broken_.is_null() || plan_.value("deviations", false)) {
      Json deviations = Json::array();
      for (const Deviation& deviation : schedule_->deviations()) {
        deviations.push_back(DeviationToJson(deviation, system_));
      }
      answer["deviations"] = std::move(deviations);
    }
    if (!broken_.is_null()) {
      answer["waits"] = Json::array();
      for (const Stall& stall : FindStalls(system_, 0)) answer["waits"].push_back(stall.text);
    }
    if (tail_max_ > 0) {
      answer["tail"] = Json::array();
      for (const SeenRecord& seen : tail_) answer["tail"].push_back(Describe(seen));
    }
  }

  PreparedRun& prepared_;
  System& system_;
  const Json& plan_;
  const int64_t for_us_;
  const int64_t until_us_;
  const int64_t slice_us_;
  const size_t tail_max_;
  const std::unique_ptr<ExploreSchedule> schedule_;
  ExactSchedule* const exact_;  // schedule_ if it is an ExactSchedule, else null
  std::vector<std::unique_ptr<Property>> properties_;
  std::vector<StandingMonitor> standing_;
  RunView view_;
  uint64_t last_message_ = 0;  // number of the message that was delivered last
  std::deque<SeenRecord> tail_;
  Json broken_;
};

}  // namespace

Json RunPlan(PreparedRun* prepared, const Json& plan, const RunOptions& options, DeviationLog* log,
             const std::function<void(const Json&)>& on_death) try {
  PlanRun run(prepared, plan, options, log);
  std::optional<EndingAction> ending_action;
  if (on_death)
    ending_action.emplace([&](Ending* ending) {
      on_death(run.AnswerForEnding(*ending));
      ending->answered = true;
    });
  return run.Run();
} catch (const Json::exception& error) {
  throw std::runtime_error(fmt::format("plan of a run: {}", error.what()));
}

}  // namespace openr_host
