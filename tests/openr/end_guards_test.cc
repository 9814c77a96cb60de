// EndGuards in the process of the test.
#include "openr/ending/end_guards.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <climits>
#include <iterator>

#include "runtime/core/code_object.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

#if !defined(__SANITIZE_ADDRESS__)  // AddressSanitizer reports crashes itself

void DoNothing(int) {}

TEST(EndGuardsTest, TheActionsOfSignalsAreRestored) {
  constexpr int kSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT};
  struct sigaction before[std::size(kSignals)];
  struct sigaction own {};
  own.sa_handler = &DoNothing;
  for (size_t i = 0; i < std::size(kSignals); ++i) sigaction(kSignals[i], &own, &before[i]);
  for (int round = 0; round < 2; ++round) {
    const EndGuards guards({});
    struct sigaction now {};
    sigaction(SIGFPE, nullptr, &now);
    EXPECT_NE(now.sa_handler, &DoNothing);
  }
  for (size_t i = 0; i < std::size(kSignals); ++i) {
    struct sigaction after {};
    sigaction(kSignals[i], &before[i], &after);
    EXPECT_EQ(after.sa_handler, &DoNothing) << kSignals[i];
  }
}

// A failed ASSERT and a signal of another process are no crashes of the object that runs.
TEST(EndGuardsTest, AnAbortOfTheRuntimeEndsTheProcessByItsSignal) {
  const auto abort_with_guards = [] {
    System system;
    system.AddRobot("ERS-210", nullptr);
    CodeObject* const object = system.AddObject<CodeObject>(0, "caller");
    const EndGuards guards({});
    const CurrentScope scope(&system, &object->host());
    raise(SIGABRT);
  };
  EXPECT_EXIT(abort_with_guards(), ::testing::KilledBySignal(SIGABRT), "");
}

#if defined(__x86_64__)  // other processors have no exception for it

// Divides as the runtime would do while an object calls it.
void DivideSmallest() {
  System system;
  system.AddRobot("ERS-210", nullptr);
  CodeObject* const object = system.AddObject<CodeObject>(0, "divider");
  const EndGuards guards({});
  const CurrentScope scope(&system, &object->host());
  volatile int smallest = INT_MIN, minus_one = -1;
  smallest = smallest / minus_one;
}

// Only code of an image goes on after this division, as on the robot.
TEST(EndGuardsTest, TheSmallestIntegerByMinusOneOutsideOfAnImageIsNoDivisionByZero) {
  EXPECT_EXIT(DivideSmallest(), ::testing::ExitedWithCode(1),
              "EXCEPTION SIGFPE \\(the smallest integer divided by -1, at which the robot would go "
              "on\\)");
}

#endif
#endif

}  // namespace
}  // namespace openr_host
