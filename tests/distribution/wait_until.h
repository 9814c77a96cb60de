// Waits for something that another process or thread does.
#pragma once

#include <unistd.h>

#include <chrono>
#include <stdexcept>
#include <string>

namespace openr_host {

// Calls `holds()` until it is true; throws after two minutes, which ends the test.
template <typename Condition>
void WaitUntil(const std::string& what, const Condition& holds) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(2);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > deadline)
      throw std::runtime_error("waited in vain for: " + what);
    usleep(1000);
  }
}

}  // namespace openr_host
