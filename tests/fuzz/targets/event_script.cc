// The fuzz target event_script: scripts of inputs.
#include "openr/run/event_script.h"

#include <stdexcept>

#include "runtime/core/system.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::event_script(std::string_view bytes) {
  static System* const system = [] {
    auto* const made = new System;
    made->AddRobot("ERS-210", nullptr);
    return made;
  }();
  const FuzzFile file(bytes);
  try {
    const EventScript script(file.path());
    return script.Check(*system).find(":5:") != std::string::npos;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace openr_host
