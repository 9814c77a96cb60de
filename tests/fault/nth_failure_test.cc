// The first, second, third ... read and allocation fails in turn: nothing crashes, nothing is
// lost without a word.
#include <gtest/gtest.h>
#include <openr/testing.h>

#include <cerrno>
#include <filesystem>
#include <memory>
#include <string>

#include "cli/install_paths.h"
#include "openr/simulation/assemble_robot.h"
#include "openr/simulation/network_setup.h"
#include "runtime/core/load_stick.h"
#include "runtime/core/stalls.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/stick/memory_stick.h"
#include "virtualrobot/body/body.h"
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
    RobotEquipment parts;
    parts.stick = std::move(stick);
    parts.body = MakeIdealBody(model_, World());
    parts.make_network = [](int) { return MakeIsolatedNetwork(); };
    AssembleRobot(&system_, model_, std::move(parts));
  }

  MemoryBudget& memory() { return system_.robot(0).memory; }

  // False when it did not boot.
  bool Go() {
    if (!LoadStick(&system_, 0)) return false;
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
      EXPECT_GT(n, 10);  // earlier rounds have made allocations fail
      break;
    }
    EXPECT_TRUE(run.Complains());
  }
}
#endif

// ---- Posts: the n-th message of the graph finds a full queue

using openr::testing::AnyMessage;
using openr::testing::Bench;
using openr::testing::BenchOptions;
using openr::testing::RefusedMessage;
using openr::testing::Snapshot;

constexpr std::chrono::seconds kLongEnoughToStand(20);

// The test tries every kEarlyStride-th of the first 300 posts (boot and first commands), and every
// kLateStride-th of the later posts, which repeat themselves.
#if defined(__SANITIZE_ADDRESS__)
constexpr uint64_t kEarlyStride = 13, kLateStride = 307;
#else
constexpr uint64_t kEarlyStride = 1, kLateStride = 23;
#endif

// Messages of the graph until the dog stands.
uint64_t CountPosts() {
  Bench bench({.stick = OPENR_STICK, .body = "ideal"});
  const RefusedMessage& posts = bench.Refuse(AnyMessage(), UINT64_MAX).Optional();
  bench.Boot();
  bench.RunUntil([&] { return bench.state("JointMover") == "accepting-commands"; },
                 kLongEnoughToStand);
  return posts.matches();
}

// Whether the dog stands in spite of it; if not, somebody must say why.
void ExpectStandingOrAWord(Bench& bench) {
  if (bench.system().booted() && bench.state("JointMover") == "accepting-commands") return;
  const bool word = bench.system().findings().HasError() ||
                    !DescribeWaits(bench.system()).empty() ||
                    bench.console().find("failed. sError") != std::string::npos;
  EXPECT_TRUE(word) << bench.Story() << bench.Findings() << bench.console();
}

TEST(NthFailureTest, PostsOfTheGraph) {
  Snapshot<Bench> unbooted([] {
    auto bench = std::make_unique<Bench>(BenchOptions{.stick = OPENR_STICK, .body = "ideal"});
    bench->AllowFindings();
    return bench;
  });
  const uint64_t count = CountPosts();
  ASSERT_GT(count, 1000u);
  for (uint64_t n = 1; n <= count; n += n < 300 ? kEarlyStride : kLateStride) {
    SCOPED_TRACE(n);
    unbooted.Run([&](Bench& bench) {
      const RefusedMessage& refused = bench.Refuse(AnyMessage(), n);
      bench.system().Boot();
      bench.RunFor(kLongEnoughToStand);
      ASSERT_TRUE(refused.happened());
      SCOPED_TRACE(refused.text());
      EXPECT_THAT(bench.Findings(), ::testing::HasSubstr("refuses a message"));
      ExpectStandingOrAWord(bench);
    });
  }
}

}  // namespace
}  // namespace openr_host
