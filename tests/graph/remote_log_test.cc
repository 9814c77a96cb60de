// The log of a motion over the remote control, beside what JointMover has reported.
#include <gtest/gtest.h>

#include "Angle.h"
#include "ByteOrder.h"
#include "RemoteLog.h"
#include "tests/graph/graph.h"
#include "tests/graph/remote_packets.h"

namespace openr_host {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

// Returns the request for records from `number` on.
std::string LogPacket(uint32_t number) {
  std::string payload;
  for (int shift = 0; shift < 32; shift += 8) payload += static_cast<char>(number >> shift);
  return RcPacket(rcLOG, payload);
}

int16_t NumberAt(const std::string& records, size_t at) {
  return static_cast<int16_t>(GetU16(reinterpret_cast<const Uint8*>(records.data()) + at));
}

TEST(RemoteLogTest, EveryKeyFrameThatJointMoverReportsIsInTheLog) {
  WhenStanding(kIdeal, [](Graph& graph) {
    auto& client = graph.AddClient();
    client.Connect(RC_PORT);
    graph.pilot().Play("BOW.MTN");
    std::string records;
    for (uint32_t next = 0; !graph.pilot().MotionIsOver(); graph.RunFor(milliseconds(200))) {
      const size_t heard = client.heard().size();
      client.Send(LogPacket(next));
      graph.RunFor(milliseconds(100));
      const auto answers = RcHeard(client.heard().substr(heard));
      ASSERT_EQ(answers.size(), 1u);
      ASSERT_EQ(answers[0].status, rcOK);
      records += answers[0].payload.substr(RcLogHead::SIZE);
      next = static_cast<uint32_t>(records.size() / 72);
    }
    const size_t heard = client.heard().size();
    client.Send(LogPacket(static_cast<uint32_t>(records.size() / 72)));
    graph.RunFor(milliseconds(100));
    records += RcHeard(client.heard().substr(heard))[0].payload.substr(RcLogHead::SIZE);
    size_t at = 0;
    for (const SetValueMessage& report : graph.pilot().reports) {
      if (report.keyFrame < 0) continue;
      ASSERT_LE(at + 72, records.size());
      EXPECT_EQ(NumberAt(records, at), report.keyFrame);
      EXPECT_EQ(NumberAt(records, at + 2), CdegFromUrad(report.commanded[0]));
      EXPECT_EQ(NumberAt(records, at + 2 + 2 * 14), CdegFromUrad(report.commanded[15]));
      EXPECT_EQ(records[at + 32], 19);
      EXPECT_EQ(NumberAt(records, at + 33), CdegFromUrad(report.measured[0]));
      at += 72;
    }
    EXPECT_EQ(at, records.size());
    EXPECT_GT(at, 72u * 5);
  });
}

}  // namespace
}  // namespace openr_host
