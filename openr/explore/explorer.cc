#include "openr/explore/explorer.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "openr/explore/shorten.h"
#include "runtime/base/hasher.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kTail = 12;  // number of last messages that the report of a failing run shows
// Largest number of seeds that a result lists because their two runs differed.
constexpr size_t kSeedsNamed = 10;

bool IsBroken(const Json& answer) { return !answer.at("broken").is_null(); }

// Gives the answers of runs to a function in the order of the numbers of the runs.  Keeps an answer
// that comes early until all answers before it have come.  So the result does not depend on the
// speed of each process.
class AnswerSorter {
 public:
  explicit AnswerSorter(std::function<void(const Json&)> take) : take_(std::move(take)) {}

  void Put(size_t number, Json answer) {
    early_[number] = std::move(answer);
    for (auto found = early_.find(next_); found != early_.end(); found = early_.find(next_)) {
      take_(found->second);
      early_.erase(found);
      ++next_;
    }
  }

 private:
  const std::function<void(const Json&)> take_;
  size_t next_ = 0;
  std::map<size_t, Json> early_;
};

// The combined result of many runs of an exploration.
class Sum {
 public:
  explicit Sum(const ExplorePlan& plan) : plan_(plan) {}

  // Returns whether more runs are wanted.  Returns false when plan_ asks to stop at the first
  // broken property and a run has broken a property.
  bool wants_more() const { return !(plan_.stop_at_first && first_broken_); }

  void Add(const Json& answer) {
    // Ignores the answers of runs that other processes had begun before a run broke a property, so
    // that the result does not depend on the number of processes.
    if (!wants_more()) return;
    ++runs_;
    if (IsBroken(answer)) {
      ++broken_;
      if (!first_broken_) first_broken_ = answer;
    }
    ++ended_by_[answer.at("ended_by").get<std::string>()];
    messages_ += answer.value("messages", uint64_t{0});
    digest_.Add(answer.at("seed").get<uint64_t>());
    digest_.AddText(answer.value("state", ""));
    digest_.AddText(answer.value("trace", ""));
    if (plan_.progress) plan_.progress(runs_);
  }

  Json Result(ExplorerProcesses* pool) const {
    Json sum = {{"runs", runs_},
                {"broken", broken_},
                {"ended_by", ended_by_},
                {"messages", messages_},
                {"digest", fmt::format("{:016x}", digest_.Digest())}};
    if (first_broken_) sum["failure"] = MakeFailure(plan_, pool, *first_broken_);
    return sum;
  }

 private:
  const ExplorePlan& plan_;
  uint64_t runs_ = 0, broken_ = 0, messages_ = 0;
  std::map<std::string, uint64_t> ended_by_;  // key: how runs ended; value: number of such runs
  Hasher digest_;
  std::optional<Json> first_broken_;
};

}  // namespace

Json MakeFailure(const ExplorePlan& plan, ExplorerProcesses* pool, const Json& answer) {
  const uint64_t seed = answer.at("seed").get<uint64_t>();
  const std::string property = answer["broken"]["property"].get<std::string>();
  Json script = answer.at("deviations");
  const size_t found = script.size();
  Json last = answer;
  const auto still_breaks = [&](const Json& candidate) -> std::optional<Json> {
    // Runs with the seed of the failing run, because the random numbers of the simulation follow
    // from the seed.
    Json result = pool->RunOne({{"seed", seed}, {"script", candidate}, {"tail", kTail}});
    if (!IsBroken(result) || result["broken"]["property"] != property) return {};
    return result;
  };
  const int runs = Shorten(still_breaks, plan.shorten_runs, &script, &last);
  Json failure = {{"seed", seed}};
  failure.update(last["broken"]);
  failure["canonical"] = script.empty();
  failure["deviations_found"] = found;
  failure["shorten_runs"] = runs;
  failure["waits"] = last.value("waits", Json::array());
  failure["tail"] = last.value("tail", Json::array());
  failure["deviations"] = std::move(script);
  return failure;
}

Json ExploreSeeds(const ExplorePlan& plan) {
  ExplorerProcesses pool(plan.prepare_run, plan.run, plan.limits, plan.jobs);
  Sum sum(plan);
  AnswerSorter sorter([&](const Json& answer) { sum.Add(answer); });
  uint64_t next_seed = plan.first_seed;
  pool.Run(
      [&]() -> std::optional<Json> {
        if (next_seed - plan.first_seed == plan.runs || !sum.wants_more()) return {};
        return Json{{"seed", next_seed++}};
      },
      [&](size_t number, Json answer) { sorter.Put(number, std::move(answer)); });
  return sum.Result(&pool);
}

Json VerifySeeds(const ExplorePlan& plan) {
  ExplorerProcesses pool(plan.prepare_run, plan.run, plan.limits, plan.jobs, true);
  Sum sum(plan);
  // The seeds for which a field of the run's answer, such as "differs", is true: their number, and
  // the first kSeedsNamed of them.
  struct MarkedSeeds {
    uint64_t count = 0;
    Json seeds = Json::array();
    void Add(const Json& answer, const char* mark) {
      if (answer[mark] && ++count <= kSeedsNamed) seeds.push_back(answer["seed"]);
    }
  };
  MarkedSeeds different, dependent, not_compared;
  AnswerSorter sorter([&](const Json& answer) {
    if (sum.wants_more()) {
      different.Add(answer, "differs");
      dependent.Add(answer, "depends_on_addresses");
      not_compared.Add(answer, "not_compared");
    }
    sum.Add(answer);
  });
  uint64_t next_seed = plan.first_seed;
  pool.Run(
      [&]() -> std::optional<Json> {
        if (next_seed - plan.first_seed == plan.runs || !sum.wants_more()) return {};
        return Json{{"seed", next_seed++}, {"twice", true}};
      },
      [&](size_t number, Json answer) { sorter.Put(number, std::move(answer)); });
  Json result = sum.Result(&pool);
  result["differences"] = different.count;
  result["different_seeds"] = std::move(different.seeds);
  result["address_dependent"] = dependent.count;
  result["address_dependent_seeds"] = std::move(dependent.seeds);
  result["not_compared"] = not_compared.count;
  result["not_compared_seeds"] = std::move(not_compared.seeds);
  return result;
}

Json ReplayDeviations(const ExplorePlan& plan, const Json& script, uint64_t seed) {
  ExplorerProcesses pool(plan.prepare_run, plan.run, plan.limits, 1);
  return pool.RunOne({{"seed", seed}, {"script", script}, {"tail", kTail}, {"deviations", true}});
}

}  // namespace openr_host
