// The status of a run on its topic, and the durations in it.
#include "distribution/status_topic.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <limits>

#include "distribution/latency.h"
#include "distribution/monitor.h"
#include "runtime/core/system.h"
#include "tests/distribution/wait_until.h"
#include "tests/runtime/core/probe.h"

namespace openr_host {
namespace {

class StatusTopicTest : public testing::Test {
 protected:
  static BusOptions Options() {
    BusOptions options;
    options.run = "status-" + std::to_string(getpid());
    return options;
  }
  // Returns what arrives of `status`.
  RunStatus Sent(RunStatus status) {
    status.run = Options().run;
    writer_.Write(status);
    const std::vector<RunStatus> heard = reader_.Take();
    EXPECT_EQ(heard.size(), 1u);
    return heard.empty() ? RunStatus() : heard[0];
  }

  Bus bus_{Options()};
  StatusReader reader_{&bus_};
  StatusWriter writer_{&bus_};
};

TEST_F(StatusTopicTest, AStatusArrivesAsItWasWritten) {
  RunStatus status;
  status.host = "den";
  status.pid = 7;
  status.virtual_us = 5;
  status.processes = {{"legs", "yard", 9, "gone"}};
  status.objects = {{1, "Mover", "legs", "standing", 128, 40, 12.5, 2, 3, 5, {4, 90, 120, 130}}};
  const RunStatus heard = Sent(status);
  EXPECT_EQ(heard.run, Options().run);
  EXPECT_EQ(heard.host, "den");
  EXPECT_EQ(heard.virtual_us, 5);
  ASSERT_EQ(heard.processes.size(), 1u);
  EXPECT_EQ(heard.processes[0].lost, "gone");
  ASSERT_EQ(heard.objects.size(), 1u);
  EXPECT_EQ(heard.objects[0].name, "Mover");
  EXPECT_EQ(heard.objects[0].messages_per_s, 12.5);
  EXPECT_EQ(heard.objects[0].handlers.p99_us, 120);
}

TEST_F(StatusTopicTest, OnlyTheNewestIsKept) {
  RunStatus status;
  status.run = Options().run;
  for (status.messages = 1; status.messages < 100; ++status.messages) writer_.Write(status);
  EXPECT_EQ(Sent(status).messages, 100u);
}

TEST_F(StatusTopicTest, ControlCharactersAreReplaced) {
  RunStatus status;
  status.objects = {{}};
  status.objects[0].name = "\x1b[2J\n\xc2\x9b";
  EXPECT_EQ(Sent(status).objects[0].name, "?[2J???");
}

TEST_F(StatusTopicTest, LongTextsAreCut) {
  RunStatus status;
  status.host = std::string(1000, 'h');
  status.processes = {{"", "", 0, std::string(1000, 'l')}};
  status.objects.resize(5000);
  status.messages_per_s = std::numeric_limits<double>::infinity();
  const RunStatus heard = Sent(status);
  EXPECT_EQ(heard.host, std::string(127, 'h'));
  EXPECT_EQ(heard.processes.at(0).lost, std::string(511, 'l'));
  EXPECT_EQ(heard.objects.size(), 4096u);
  EXPECT_EQ(heard.objects_left_out, 904u);
  EXPECT_EQ(heard.messages_per_s, 0);
}

// The final status must not have rates over a very short time.
TEST(MonitorTest, TheFinalStatusRepeatsTheLastRates) {
  BusOptions options;
  options.run = "monitor-" + std::to_string(getpid());
  Bus bus(options);
  StatusReader reader(&bus);
  System system;
  system.AddRobot("ERS-210", nullptr);
  system.AddObject<SubjectProbe>(0, "sender");
  Monitor monitor(&system, &bus, nullptr);
  system.Boot();
  system.RunFor(1000);
  std::vector<RunStatus> said;
  WaitUntil("what it says", [&] {
    monitor.PublishIfDue();
    said = reader.Take();
    return !said.empty();
  });
  EXPECT_GT(said[0].messages_per_s, 0);
  system.robot_table().NoteRunEnd({EndKind::kTime, "--for 1ms is over"});
  monitor.End();
  const std::vector<RunStatus> at_end = reader.Take();
  ASSERT_EQ(at_end.size(), 1u);
  EXPECT_TRUE(at_end[0].has_ended);
  EXPECT_EQ(at_end[0].end, "ended by time: --for 1ms is over");
  EXPECT_EQ(at_end[0].messages_per_s, said[0].messages_per_s);
  EXPECT_EQ(at_end[0].x_real_time, said[0].x_real_time);
  ASSERT_GT(said[0].objects.size(), 1u);
  EXPECT_GT(said[0].objects[1].messages_per_s, 0);
  EXPECT_EQ(at_end[0].objects[1].messages_per_s, said[0].objects[1].messages_per_s);
}

TEST(LatencyTest, SinceReturnsTheDurationsAddedToACopy) {
  Latency latency;
  for (int i = 0; i < 100; ++i) latency.Add(1'000'000);
  const Latency before = latency;
  latency.Add(2'000);
  latency.Add(4'000);
  const Latency since = latency.Since(before);
  EXPECT_EQ(since.count(), 2u);
  EXPECT_DOUBLE_EQ(since.MeanUs(), 3);
  EXPECT_NEAR(since.MaxUs(), 4, 4.0 / 16);
  EXPECT_NEAR(since.PercentileUs(0.5), 2, 2.0 / 16);
  EXPECT_EQ(latency.Since(latency).count(), 0u);
  EXPECT_EQ(latency.Since(latency).MeanUs(), 0);
  EXPECT_EQ(latency.Since(latency).PercentileUs(0.99), 0);
}

}  // namespace
}  // namespace openr_host
