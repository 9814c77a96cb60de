// SystemOptions: the settings of a System, which do not change while it runs.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace openr_host {

class CostModel;
class System;
class SystemCalls;
struct Message;

struct SystemOptions {
  // The seed of everything that is random.  With seed 1, messages have the same order as without a
  // schedule (schedule.h).  With any other seed, the order is drawn at random from the orders that
  // the robot allows.
  uint64_t seed = 1;
  // If true, a mistake of a program that would stop a real robot also stops the robot of this run.
  // If false, such a mistake only becomes a finding, a line in the report of the run.  If true,
  // objects also receive read-only copies of data (guard_pages.h), because writing to received data
  // is such a mistake.
  bool strict = false;
  // A function that receives what objects print.  If it is null, they print to standard output.
  std::function<void(std::string_view text)> console = {};
  // The largest priority number of the OSYSLOG lines that are printed (1 error, 2 warning, 3 info).
  // Debug lines are always printed.
  uint32_t log_level = 3;
  // The number of messages, at least 1, that may be delivered at one instant of virtual time.
  // Messages posted after them are due 1 us later.  Otherwise objects that answer each other
  // without waiting would stop the clock.
  int64_t free_deliveries = 10'000;
  // Wall clock in nanoseconds, which measures Object::handler_ns_max.  If it is null, nothing is
  // measured.  No other part of a run may depend on this clock, because it differs from run to run.
  int64_t (*wall_clock_ns)() = nullptr;
  // The model of how much processor time handlers take (cpu.h).  If it is null, they take no time.
  std::shared_ptr<CostModel> cost = {};
  // If true, Object::stack_max is measured for images (objects that were loaded from files).
  bool measure_stacks = false;
  // If true, objects receive read-only copies of data (guard_pages.h).  When an object asserts
  // ready, its copies are unmapped, so every later access is a fault.  If a subject changes data
  // before they are received, an error finding is added.  The copies cost some microseconds per
  // notification.
  bool guard_regions = false;
  // If true, the heaps of images record where each block was allocated, for ReportLeaks()
  // (leaks.h).
  bool find_leaks = false;
  // Describes in words the content of `message`, which an object handles now.  Findings get this
  // text (Finding::said).  If this function is null, findings have no such text.
  std::string (*say)(const System& system, const Message& message) = nullptr;
  // Makes the SystemCalls of this System, the functions that handlers call.  If this function is
  // null, the System makes LocalCalls.
  std::function<std::unique_ptr<SystemCalls>(System*)> make_calls = {};
};

}  // namespace openr_host
