#include "openr/explore/failing_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "openr/explore/deviation.h"
#include "runtime/base/assert.h"
#include "runtime/core/system.h"

namespace openr_host {

FailingRun::FailingRun(const PrepareRun& prepare, const nlohmann::ordered_json& script,
                       uint64_t seed, int64_t for_us, const nlohmann::ordered_json& answer)
    : prepared_(prepare()), length_us_(for_us), why_("the run is over; no property is broken") {
  if (!prepared_.problem.empty()) throw std::runtime_error(prepared_.problem);
  ASSERT(prepared_.simulation != nullptr, "a run of a schedule file is one of a stick");
  std::vector<Deviation> deviations;
  for (const auto& line : script) deviations.push_back(DeviationFromJson(line, *prepared_.system));
  schedule_ = std::make_unique<ScriptedSchedule>(*prepared_.system, deviations);
  if (const auto& broken = answer.at("broken"); !broken.is_null()) {
    // If the run of `answer` has crashed, or was killed because it did not end, the time of its
    // failure is null.  This FailingRun then goes on for `for_us`, the length of each run of an
    // exploration.
    const bool has_time = !broken.at("time_us").is_null();
    if (has_time) length_us_ = broken["time_us"].get<int64_t>();
    why_ =
        fmt::format("{} the property '{}' is broken: {}", has_time ? "here" : "the run is over;",
                    broken.at("property").get<std::string>(), broken.at("text").get<std::string>());
  }
  SetSchedule(&prepared_, seed, schedule_.get(), for_us);
  prepared_.system->Boot();
}

void FailingRun::RunOne(int64_t time_us) {
  if (prepared_.system->powered_off()) return;
  prepared_.system->RunOne(std::min(time_us, length_us_));
}

std::string FailingRun::EndReason() const {
  const System& system = *prepared_.system;
  return system.now_us() < length_us_ && !system.powered_off() ? "" : why_;
}

}  // namespace openr_host
