// Searches all orders of messages of the objects of a stick, depth first.  For each run, the search
// decides the first choices between orders, so that the run begins like the run before and then
// makes another choice.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "cli/counted.h"
#include "openr/explore/exact_schedule.h"
#include "openr/explore/explorer.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// A choice in the last run: the candidates (objects that could get the next message), and which of
// them have been explored.
struct Choice {
  std::vector<ObjectId> candidates;
  SleepSet sleep;  // deliveries that sleep at this choice, so the search need not try them
  SleepSet done;   // explored candidates; value: the objects that the candidate's delivery concerns
  size_t current = 0;
  UsedObjects used;  // objects that the delivery of the current candidate's message concerns
};

class Search {
 public:
  Search(const ExplorePlan& plan, ExplorerProcesses* pool) : plan_(plan), pool_(*pool) {}

  Json Run() {
    do {
      if (runs_ == plan_.runs) {
        stopped_ = "at the bound of " + Counted(plan_.runs, "run");
        break;
      }
      AddRun(pool_.RunOne(NextPlan()));
      if (failure_ && plan_.stop_at_first) stopped_ = "at the first broken property";
    } while (stopped_.empty() && Backtrack());
    return Result();
  }

 private:
  Json NextPlan() const {
    Json choices = Json::array();
    for (const Choice& choice : stack_) choices.push_back(choice.current);
    SleepSet sleep;
    if (!stack_.empty() && plan_.reduce) {
      sleep = stack_.back().sleep;
      for (const auto& [object, used] : stack_.back().done) sleep[object] = used;
    }
    return {
        {"seed", plan_.first_seed},
        {"exact", {{"choices", choices}, {"sleep", SleepToJson(sleep)}, {"reduce", plan_.reduce}}}};
  }

  void AddRun(const Json& answer) {
    ++runs_;
    if (plan_.progress) plan_.progress(runs_);
    if (!answer.at("broken").is_null()) {
      ++broken_;
      if (!failure_) failure_ = answer;
    }
    if (!answer.contains("exact") || !answer["exact"]["cut"].get<bool>())
      ++ended_by_[answer.at("ended_by").get<std::string>()];
    if (!answer.contains("exact")) return CountCrashedRun();
    const Json& exact = answer["exact"];
    ++(exact["cut"].get<bool>() ? cut_ : orders_);
    const Json& nodes = exact["nodes"];
    choices_max_ = std::max(choices_max_, nodes.size());
    for (size_t i = 0; i < nodes.size(); ++i) {
      if (i == stack_.size()) {
        Choice choice;
        choice.candidates = nodes[i]["candidates"].get<std::vector<ObjectId>>();
        choice.sleep = SleepFromJson(nodes[i]["sleep"]);
        choice.current = nodes[i]["chosen"].get<size_t>();
        stack_.push_back(std::move(choice));
      }
      stack_[i].used = UsedObjectsFromJson(nodes[i]["touched"]);
    }
  }

  // Counts a run that crashed, and ends the search.  The process of such a run could not report the
  // run's choices, so the search does not know what else it would have to try.
  void CountCrashedRun() {
    ++orders_;
    stopped_ = "at a run that did not come to its end";
  }

  // Goes back to the last choice at which another candidate (an object that could get the next
  // message) has to be explored, and takes this candidate.  Returns false when no such choice is
  // left.
  bool Backtrack() {
    while (!stack_.empty()) {
      Choice& choice = stack_.back();
      choice.done[choice.candidates[choice.current]] = choice.used;
      for (size_t i = 0; i < choice.candidates.size(); ++i) {
        const ObjectId candidate = choice.candidates[i];
        if (choice.done.contains(candidate) || choice.sleep.contains(candidate)) continue;
        choice.current = i;
        return true;
      }
      stack_.pop_back();
    }
    return false;
  }

  // Returns the explored share of the tree of choices, 0 to 1.  The tree is not known before it is
  // explored, so all candidates of a choice count as equal parts of the tree below this choice.
  double Covered() const {
    if (stopped_.empty()) return 1;
    double covered = 0, weight = 1;
    for (const Choice& choice : stack_) {
      weight /= static_cast<double>(choice.candidates.size());
      for (const ObjectId candidate : choice.candidates) {
        if (choice.done.contains(candidate) || choice.sleep.contains(candidate)) covered += weight;
      }
    }
    return covered;
  }

  Json Result() {
    Json result = {{"runs", runs_},         {"orders", orders_},
                   {"cut", cut_},           {"broken", broken_},
                   {"ended_by", ended_by_}, {"complete", stopped_.empty()},
                   {"covered", Covered()},  {"choices_max", choices_max_}};
    if (!stopped_.empty()) result["stopped"] = stopped_;
    if (failure_) result["failure"] = MakeFailure(plan_, &pool_, *failure_);
    return result;
  }

  const ExplorePlan& plan_;
  ExplorerProcesses& pool_;
  std::vector<Choice> stack_;
  uint64_t runs_ = 0, orders_ = 0, cut_ = 0, broken_ = 0;
  // The number of orders for each reason of the run's end, such as "time"; the key is the reason.
  std::map<std::string, uint64_t> ended_by_;
  size_t choices_max_ = 0;
  std::string stopped_;
  std::optional<Json> failure_;
};

}  // namespace

Json SearchOrders(const ExplorePlan& plan) {
  ExplorerProcesses pool(plan.prepare_run, plan.run, plan.limits, 1);
  return Search(plan, &pool).Run();
}

}  // namespace openr_host
