// The fuzz target schedule: schedule files of openr explore.
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "openr/explore/exact_schedule.h"
#include "openr/explore/schedule_file.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::schedule(std::string_view bytes) {
  const FuzzFile file(bytes);
  try {
    nlohmann::ordered_json deviations;
    const ScheduleFile schedule = ReadScheduleFile(file.path(), &deviations);
    return schedule.stick.simulation.strict && schedule.seed > 100;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace openr_host
