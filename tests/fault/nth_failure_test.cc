// The first, second, third ... read and allocation fails in turn: nothing crashes, nothing is
// lost without a word.
#include <gtest/gtest.h>

#include <cerrno>
#include <filesystem>
#include <memory>
#include <string>

#include "openr/install_paths.h"
#include "openr/network_setup.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/stick/memory_stick.h"
#include "virtualrobot/body.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// The default stick's graph on the ideal body, for one second.
class GraphRun {
 public:
  explicit GraphRun(std::shared_ptr<MemoryStick> stick)
      : model_(LoadRobotModel(ModelFile("ers210"))),
        system_({.console = [this](std::string_view text) { console_ += text; }}) {
    system_.AddRobot(model_.design, std::move(stick));
    AddVirtualRobot(&system_, 0, model_, MakeIdealBody(model_, World()));
    AddIpStack(&system_, 0, MakeLonelyNetwork());
  }

  MemoryBudget& memory() { return system_.robot(0).memory; }

  // False when it did not boot.
  bool Go() {
    if (!system_.LoadStick(0)) return false;
    system_.Boot();
    system_.RunFor(1'000'000);
    return system_.booted();
  }

  bool Complains() const {
    return !system_.findings().all().empty() || console_.find("prio:1]") != std::string::npos;
  }

 private:
  const RobotModel model_;
  std::string console_;
  System system_;
};

std::shared_ptr<MemoryStick> DefaultFolder() { return std::make_shared<FolderStick>(OPENR_STICK); }

TEST(NthFailureTest, ReadsOfTheStick) {
  GraphRun whole(DefaultFolder());
  ASSERT_TRUE(whole.Go());
  ASSERT_FALSE(whole.Complains());
  int failures = 0;
  for (int n = 1;; ++n) {
    SCOPED_TRACE(n);
    const auto stick = std::make_shared<FailingStick>(DefaultFolder(), n, EIO);
    GraphRun run(stick);
    run.Go();
    if (!stick->has_failed()) break;
    ++failures;
    const fs::path name = stick->failed_name();
    // Without these there are defaults.
    EXPECT_TRUE(run.Complains() || name.stem() == "DESIGNDB" ||
                name.stem().string().starts_with("WLAN"))
        << name << " could not be read, and nobody said so";
  }
  EXPECT_GE(failures, 7);  // three files of CONF, four images
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(NthFailureTest, AllocationsOfObjects) {
  for (int n = 1;; ++n) {
    SCOPED_TRACE(n);
    GraphRun run(DefaultFolder());
    run.memory().allocations_until_failure = n;
    run.Go();
    if (run.memory().allocations_until_failure > 0) {
      EXPECT_GT(n, 10);  // there were allocations to fail
      break;
    }
    EXPECT_TRUE(run.Complains());
  }
}
#endif

}  // namespace
}  // namespace openr_host
