// Many runs of one graph: random orders, each seed twice, or all orders there are.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "openr/explore/worker_pool.h"

namespace openr_host {

struct ExplorePlan {
  PrepareRun prepare_run;
  RunOptions run;
  ForkLimits limits;
  uint64_t first_seed = 1;
  uint64_t runs = 100;        // seeds; of a search the most runs
  int jobs = 1;               // worker processes
  bool reduce = true;         // of a search: leave out orders equal to others
  bool stop_at_first = true;  // at the first seed that breaks a property
  int shorten_runs = 2000;    // the most runs for shortening; 0: not at all
  // Told now and then how many runs are done, for people; may be empty.
  std::function<void(uint64_t runs)> progress;
};

// A run per seed.  The result does not depend on `jobs`:
//   "runs", "broken" (how many), "messages", "digest" (of all hashes, in order of seeds), and when
//   a property was broken "failure": of the lowest seed that did.  With stop_at_first, runs are
//   those up to that seed.
nlohmann::ordered_json ExploreSeeds(const ExplorePlan& plan);

// Two runs per seed, the second one sliced differently.  As above, with "differences" (seeds whose
// hashes of trace or state differ) and the first "different_seeds".
nlohmann::ordered_json VerifySeeds(const ExplorePlan& plan);

// All orders of starts and ties, depth first: "runs", "orders" (runs that were an order of their
// own), "cut" (runs that turned out to be equal to others), "complete", "covered" (share of the
// tree, 0 to 1), "choices_max" (in one run), "stopped" (why, when not complete), "failure".
nlohmann::ordered_json SearchOrders(const ExplorePlan& plan);

// Runs deviations again.  The answer of RunPlan(), with its tail.
nlohmann::ordered_json ReplayDeviations(const ExplorePlan& plan,
                                        const nlohmann::ordered_json& script, uint64_t seed);

// What a failure holds, for all of the above: "seed", "property", "time_us", "message", "text",
// "waits", "tail", "deviations" (shortened), "deviations_found" (before), "shorten_runs",
// "canonical" (true: it fails without any deviation as well).
nlohmann::ordered_json MakeFailure(const ExplorePlan& plan, WorkerPool* pool,
                                   const nlohmann::ordered_json& answer);

}  // namespace openr_host
