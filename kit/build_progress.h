// Shows on a terminal how many sources of a build are compiled.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "kit/make_build.h"

namespace openr_host {

// Calls `work`, which runs make with `options`, and shows the progress on a terminal meanwhile.
// `count` returns the number of sources that `work` compiles, 0 if nothing is to be shown, or
// nullopt if the number is not known before make runs.  After nullopt, only the number of finished
// sources is shown.  `count` is called only if there is a terminal.
void ShowBuildProgress(MakeOptions* options, const std::function<std::optional<uint64_t>()>& count,
                       const std::function<void()>& work);

}  // namespace openr_host
