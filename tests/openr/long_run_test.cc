// A run that goes on for long takes no more memory.
#include <gtest/gtest.h>
#include <malloc.h>

#include <string_view>

#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

size_t AllocatedBytes() {
  const struct mallinfo2 facts = mallinfo2();
  return facts.uordblks + facts.hblkhd;
}

TEST(LongRunTest, TenMinutesOfVirtualTimeTakeNoMoreMemoryThanOne) {
  SimulationOptions options;
  options.body = "ideal";
  options.writable_stick = false;
  options.host_network = false;
  options.console = [](std::string_view) {};
  Simulation simulation(options);
  System& system = simulation.system();
  system.Boot();
  system.RunFor(60'000'000);
  const size_t before = AllocatedBytes();
  system.RunFor(540'000'000);
  EXPECT_LE(AllocatedBytes(), before + 1024);
  size_t heap = 0;
  for (const auto& object : system.objects()) {
    if (object->memory().arena() != nullptr) heap += object->memory().arena()->bytes_in_use_max();
  }
  EXPECT_GT(heap, 0u) << "the objects of the stick have not run";
}

#endif

}  // namespace
}  // namespace openr_host
