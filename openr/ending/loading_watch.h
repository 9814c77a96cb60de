// Reports errors of the code that runs while images are loaded.
#pragma once

#include <optional>

#include "openr/ending/crash_log.h"
#include "openr/ending/ending.h"
#include "openr/ending/watchdog.h"

namespace openr_host {

// While a LoadingWatch exists, a crash during the loading of an image, and constructors that do not
// return, end the process with a message that names the object.  A LoadingWatch makes an
// EndingAnswer, a CrashLog that writes no file, and a Watchdog, but only those that the command
// that loads the images has not made itself.
class LoadingWatch {
 public:
  LoadingWatch();
  LoadingWatch(const LoadingWatch&) = delete;
  LoadingWatch& operator=(const LoadingWatch&) = delete;

 private:
  std::optional<EndingAnswer> ending_answer_;
  std::optional<CrashLog> crash_log_;
  std::optional<Watchdog> watchdog_;
};

}  // namespace openr_host
