// A handler needs another stack, and this computer has no memory for it.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <utility>

#include "runtime/core/address_plan.h"
#include "runtime/core/arena.h"
#include "runtime/core/image_object.h"
#include "runtime/core/robot_fault.h"
#include "tests/runtime/core/recorder.h"

namespace {

bool g_stacks_fail = false;

}  // namespace

// Replaces mmap() of the C library for this program, so that mappings for stacks can fail.
extern "C" void* mmap(void* address, size_t bytes, int protection, int flags, int file,
                      off_t offset) noexcept {
  if (g_stacks_fail && (flags & MAP_STACK) != 0) {
    errno = ENOMEM;
    return MAP_FAILED;
  }
  return reinterpret_cast<void*>(
      syscall(SYS_mmap, address, bytes, protection, flags, file, offset));
}

namespace openr_host {
namespace {

// Handles a message with `work` while no stack can be made.  Ends the process with status 3 if an
// object stops as the robot does, and prints why.
void HandleWithoutStacks(const std::function<void(System*)>& work) {
  signal(SIGILL, [](int) {
    std::fputs(AnnouncedFault(), stderr);
    _exit(3);
  });
  Log log;
  System system;
  system.AddRobot("ERS-210", nullptr);
  Recorder* const a = system.AddObject<Recorder>(0, "a", &log);
  a->on_message = [&](int) {
    g_stacks_fail = true;
    work(&system);
  };
  PostTo(a, 1);
  system.RunFor(100);
}

void WaitForNothing(System* system) {
  system->requests().Wait(system->requests().OpenBox(), nullptr, 0, nullptr, 10, "nothing");
}

TEST(StackFailureTest, AHandlerThatCannotWaitIsACrashOfItsObject) {
  EXPECT_EXIT(HandleWithoutStacks(&WaitForNothing), testing::ExitedWithCode(3),
              "no memory for a stack");
}

TEST(StackFailureTest, AHandlerThatCannotBeAbandonedIsACrashOfItsObject) {
  EXPECT_EXIT(HandleWithoutStacks([](System* system) { system->AbandonHandler(); }),
              testing::ExitedWithCode(3), "no memory for a stack");
}

// An image with a heap of its own, in place of a file: its only entry waits for 10 us.
class WaitingImage : public ImageObject {
 public:
  WaitingImage(System* the_system, ObjectId the_id) : ImageObject(the_system, the_id, 0) {
    name = "waiting";
    auto addresses = std::make_unique<ObjectAddresses>(id);
    if (addresses->heap() != nullptr)
      memory().Plan(std::move(addresses), &system->robot(robot).memory);
  }
  bool HasEntry(uint32_t) const override { return true; }
  bool Dispatch(uint32_t, void*) override {
    const ApiScope scope;
    WaitForNothing(system);
    return true;
  }
};

// When the wait ends, the dispatcher puts the stack that it has used meanwhile into its list of
// unused stacks.  The memory of this list must not be the object's.
TEST(StackFailureTest, AWaitTakesNoMemoryOfTheObjectsHeap) {
  System system;
  system.AddRobot("ERS-210", nullptr);
  const ObjectId id = system.object_table().IdFor(0, "waiting");
  auto image = std::make_unique<WaitingImage>(&system, id);
  const Arena* const arena = image->memory().arena();
  if (arena == nullptr) GTEST_SKIP() << "sanitizers bring a heap of their own";
  system.object_table().Adopt(std::move(image));
  system.Post(system.NewMessage(id, oentryBASE));
  system.RunFor(100);
  EXPECT_EQ(arena->bytes_in_use_max(), 0u);
}

}  // namespace
}  // namespace openr_host
