// Explores one graph with many runs: random orders, each seed twice, or all orders.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "openr/explore/explorer_processes.h"

namespace openr_host {

struct ExplorePlan {
  PrepareRun prepare_run;
  RunOptions run;
  ForkLimits limits;
  uint64_t first_seed = 1;
  uint64_t runs = 100;        // number of seeds; for a search, limit of runs
  int jobs = 1;               // child processes that run plans
  bool reduce = true;         // for a search: leave out orders equal to others
  bool stop_at_first = true;  // stop at the first seed that breaks a property
  int shorten_runs = 2000;    // limit of runs for shortening; 0: no shortening
  // A function that is called now and then with the number of finished runs, to show progress; may
  // be empty.
  std::function<void(uint64_t runs)> progress;
};

// Makes a run per seed.  The result does not depend on `jobs`.  It has
//   "runs", "broken" (number of seeds that broke a property), "messages", "digest" (of all hashes,
//   in the order of seeds), and "failure" of the lowest seed that broke a property, if one did.
// With stop_at_first, "runs" counts the runs up to that seed.
nlohmann::ordered_json ExploreSeeds(const ExplorePlan& plan);

// Makes two runs per seed, the second one in time slices of another length.  The result is as
// above, with "differences" (number of seeds whose hashes of trace or state differ) and the first
// "different_seeds".
nlohmann::ordered_json VerifySeeds(const ExplorePlan& plan);

// Tries all orders of starts and ties, depth first.  The result has
//   "runs", "orders" (runs with an order of their own), "cut" (runs that turned out to be equal to
//   others), "complete", "covered" (explored share of the tree, 0 to 1), "choices_max" (in one
//   run), "stopped" (the reason, if not complete), "failure".
nlohmann::ordered_json SearchOrders(const ExplorePlan& plan);

// Runs `plan` with given deviations.  Returns the answer of RunPlan(), with its tail.
nlohmann::ordered_json ReplayDeviations(const ExplorePlan& plan,
                                        const nlohmann::ordered_json& script, uint64_t seed);

// Returns the "failure" of all functions above:
//   "seed", "property", "time_us", "message", "text", "waits", "tail", "deviations" (shortened),
//   "deviations_found" (number before shortening), "shorten_runs", "canonical" (true: the property
//   is broken without any deviation too).
nlohmann::ordered_json MakeFailure(const ExplorePlan& plan, ExplorerProcesses* pool,
                                   const nlohmann::ordered_json& answer);

}  // namespace openr_host
