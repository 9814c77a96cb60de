// Shows on a terminal how many sources of a build are compiled.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "kit/make_build.h"

namespace openr_host {

// Calls `work`, which runs make with `options`, and shows the progress on a terminal meanwhile.
// `count` returns how many sources the work compiles; it is called only if there is a terminal.  If
// it returns nullopt, the number is not known before make runs, and only the number of finished
// sources is shown.  If it returns 0, nothing is shown.
void ShowBuildProgress(MakeOptions* options, const std::function<std::optional<uint64_t>()>& count,
                       const std::function<void()>& work);

}  // namespace openr_host
