// A notification that a full queue refuses when the processor time of its handler is over
// (runtime/core/cpu.h), in one process and in several.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/distribution/sticks.h"

namespace openr_host {
namespace {

using testing::ContainsRegex;

class LateRefusalTest : public testing::Test {
 protected:
  void SetUp() override {
    MakeStick(stick_, {"PUSHER.BIN", "LISTENER.BIN"}, "Pusher.Out.Number.S Listener.In.Number.O\n");
    stick_.Write("cost.txt", "pusher Push 2000\nlistener Fill 3000\n");
  }
  Words Flags(const Words& isolated = {}) const {
    return Words{"--stick", stick_.path(), "--strict", "--cost", stick_.File("cost.txt"),
                 "--for",   "1500ms"} +
           Isolated(isolated);
  }

  const ScratchFolder stick_;
};

// Number 20 is refused when the processor time of its handler is over.  The notification of 30
// sends it.  Number 40 is refused as well, but 41, which the same handler has sent, replaces it.
TEST_F(LateRefusalTest, ItsDataWaitForTheNextNotification) {
  for (const Words& isolated : {Words{}, Words{"pusher"}}) {
    const ProgramResult run = RunProgram(kQuickly + Flags(isolated));
    EXPECT_THAT(run.err, ContainsRegex("heard 10\nheard 20\nheard 41\n")) << run.err;
  }
}

TEST_F(LateRefusalTest, TheRunIsTheSameInOtherProcesses) {
  const RecordedRun alone = Record(Flags());
  ExpectSame(alone, Record(Flags({"pusher"})));
  ExpectSame(alone, Record(Flags({"listener"})));
  ExpectSame(alone, Record(Flags({"pusher", "listener"})));
}

}  // namespace
}  // namespace openr_host
