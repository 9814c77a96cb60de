// Explores the objects of a stick with many runs: random orders of messages, two runs of each seed
// that must be equal, or all possible orders.
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
  uint64_t runs = 100;  // number of seeds; for SearchOrders(): the largest number of runs
  int jobs = 1;         // number of child processes that make runs at the same time
  // True: SearchOrders() tries only one of several orders of messages with equal results.
  bool reduce = true;
  bool stop_at_first = true;  // true: stops at the first seed that breaks a property
  // Largest number of runs that may be made to find which deviations a failure needs; 0: no such
  // run is made.
  int shorten_runs = 2000;
  // A function that is called after each run with the number of runs so far, to show progress; may
  // be empty.  The runs that `shorten_runs` limits do not count.
  std::function<void(uint64_t runs)> progress;
};

// Makes one run for each seed.  Returns a JSON object, which does not depend on the number of child
// processes, with
//   "runs", "broken" (number of seeds that broke a property), "ended_by" (number of runs for each
//   reason of their end), "messages", "digest" (hash over all runs, in the order of seeds), and
//   "failure" (MakeFailure()) of the lowest seed that broke a property, if one did.
// If the plan has stop_at_first, only the runs of seeds up to the one in "failure" are counted.
nlohmann::ordered_json ExploreSeeds(const ExplorePlan& plan);

// Makes two runs for each seed; the second one is in a process with other memory addresses, and is
// advanced in time slices of another length.  Both runs of a correct program have the same result.
// Returns the fields of ExploreSeeds() and three more.  "differences" is the number of seeds whose
// two runs differ in the hash of trace or state.  "address_dependent" is the number of seeds that
// differ only because of the other addresses.  "not_compared" is the number of seeds of which a run
// was killed after ForkLimits::wall_s.  Also returns the first seeds of each of these three kinds.
nlohmann::ordered_json VerifySeeds(const ExplorePlan& plan);

// Tries, depth first, all orders in which objects can start, and all orders in which messages that
// are due at the same time can be delivered.  Returns a JSON object with
//   "runs", "orders" (runs that were not cut; each has another order), "cut" (runs stopped early
//   because they repeated an earlier order), "broken" (runs that broke a property), "ended_by"
//   (number of orders for each reason of the run's end), "complete" (all orders were tried),
//   "covered" (explored share of the tree of choices, 0 to 1), "choices_max" (largest number of
//   choices in a run), "stopped" (the reason, if not complete), "failure" (MakeFailure()).
nlohmann::ordered_json SearchOrders(const ExplorePlan& plan);

// Makes one run with the deviations `script`, which come from a schedule file.  `seed` is the seed
// in this file; it decides the random numbers of the simulation.  Returns the answer of RunPlan(),
// with the last messages of the run.
nlohmann::ordered_json ReplayDeviations(const ExplorePlan& plan,
                                        const nlohmann::ordered_json& script, uint64_t seed);

// Returns the description of a failure, which is the field "failure" in the results of
// ExploreSeeds(), VerifySeeds() and SearchOrders().  `answer` is the answer of the run that broke a
// property.  `pool` makes more runs, to find the deviations that are needed to break the property.
// The description has
//   "seed", "property", "time_us", "message", "text", "waits", "tail" (as in RunPlan()),
//   "deviations" (the differences from an ordinary run that are needed to break the property, such
//   as another order of messages; see deviation.h),
//   "deviations_found" (number of deviations in the run of `answer`, needed or not),
//   "shorten_runs" (number of runs made by `pool`), "canonical" (true: the property is broken
//   without any deviation too).
nlohmann::ordered_json MakeFailure(const ExplorePlan& plan, ExplorerProcesses* pool,
                                   const nlohmann::ordered_json& answer);

}  // namespace openr_host
