// Constructors of global objects that send messages to their own object and register it, in one
// process and in a worker.
#include <gtest/gtest.h>

#include "tests/distribution/sticks.h"

namespace openr_host {
namespace {

TEST(ConstructorsTest, TheirMessagesAndNamesAreTheSameInAWorker) {
  const ScratchFolder stick;
  MakeStick(stick, {"PROBE.BIN"}, "");
  stick.Write("OPEN-R/MW/DATA/P/OWN.TXT", "");
  for (const Words& more : {Words{}, Words{"--strict"}}) {
    const Words flags = Words{"--stick", stick.path(), "--for", "1s"} + more;
    const RecordedRun alone = Record(flags);
    EXPECT_EQ(alone.status, 0) << alone.err;
    ExpectSame(alone, Record(flags + Isolated({"probe"})));
    for (const json& object : alone.report["objects"]) {
      if (object["name"] != "probe") continue;
      EXPECT_EQ(object["messages"], 4) << "DoInit, DoStart, and two to DoEarly";
    }
  }
}

}  // namespace
}  // namespace openr_host
