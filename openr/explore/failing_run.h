// FailingRun: repeats the failing run of a schedule file, up to the failure.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "openr/explore/explore_schedule.h"
#include "openr/explore/prepared_run.h"
#include "openr/simulation/known_run.h"

namespace openr_host {

class FailingRun : public KnownRun {
 public:
  // Boots the run that `prepare` assembles, with the deviations `script` (deviation.h) and the seed
  // `seed`, both from the schedule file.  `answer` is the answer of ReplayDeviations().  If the
  // answer has the time and the reason of a failure, this run goes on until that time.  Otherwise
  // this run goes on for `for_us`.  Throws std::runtime_error if the run cannot start.
  FailingRun(const PrepareRun& prepare, const nlohmann::ordered_json& script, uint64_t seed,
             int64_t for_us, const nlohmann::ordered_json& answer);

  Simulation& simulation() override { return *prepared_.simulation; }
  void RunOne(int64_t time_us) override;
  int64_t length_us() const override { return length_us_; }
  std::string EndReason() const override;

 private:
  PreparedRun prepared_;
  std::unique_ptr<ExploreSchedule> schedule_;
  int64_t length_us_;
  std::string why_;  // text about the failure of the run
};

}  // namespace openr_host
