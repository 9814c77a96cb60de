// Constructors of global objects that send messages, ask and register, in one process, in a worker
// and in a restarted worker.
#include <gmock/gmock.h>

#include "tests/distribution/sticks.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The objects of tests/images/Early, whose constructors ask Oracle.
class ConstructorsTest : public testing::Test {
 protected:
  ConstructorsTest() {
    MakeStick(stick_, {"ORACLE.BIN", "FIRST.BIN", "SECOND.BIN"}, "");
    stick_.Write("OPEN-R/MW/DATA/P/README.TXT", "");
  }
  Words OnStick(const Words& flags) const {
    return Words{"--stick", stick_.path(), "--body", "ideal"} + flags;
  }
  // EXPECTs that First and Second are the same in one process and in workers.
  void ExpectSameApart(const RecordedRun& alone, const Words& flags) const {
    ExpectSame(alone, Record(flags + Isolated({"First"})));
    ExpectSame(alone, Record(flags + Isolated({"First", "Second"})));
    ExpectSame(alone, Record(flags + kPair));
  }

  inline static const Words kPair = {"--place", "First=pair", "--place", "Second=pair"};
  const ScratchFolder stick_;
};

TEST(EarlyProbeTest, MessagesAndNamesOfConstructorsAreTheSameInAWorker) {
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

// A worker opens boxes behind those that a constructor has opened; the master knows of none then.
TEST(EarlyProbeTest, TheirReplyBoxesAreNotOpenedAgainInAWorker) {
  const ScratchFolder stick;
  MakeStick(stick, {"PROBE.BIN"}, "");
  stick.Write("OPEN-R/MW/DATA/P/OWN.TXT", "");
  stick.Write("OPEN-R/MW/DATA/P/ASK.TXT", "");
  const Words flags = {"--stick", stick.path(), "--for", "1s"};
  const RecordedRun alone = Record(flags);
  EXPECT_EQ(alone.status, 0) << alone.err;
  ExpectSame(alone, Record(flags + Isolated({"probe"})));
  for (const json& object : alone.report["objects"]) {
    if (object["name"] != "probe") continue;
    EXPECT_EQ(object["messages"], 7) << "DoInit, DoStart, and five to DoEarly";
  }
}

// The request of a constructor opens a reply box, and nothing after it needs an answer at once.
TEST_F(ConstructorsTest, RepliesToTheirRequestsArriveInAWorker) {
  for (const Words& more : {Words{}, Words{"--strict"}, Words{"--seed", "7"}}) {
    const Words flags = OnStick(Words{"--for", "500ms"} + more);
    const RecordedRun alone = Record(flags);
    EXPECT_EQ(alone.status, 0) << alone.err;
    EXPECT_THAT(alone.err, HasSubstr("First: heard 1, keeps 1 1, answer 1"));
    EXPECT_THAT(alone.err, HasSubstr("Second: heard 1, keeps 1 1, answer 2"));
    ExpectSameApart(alone, flags);
  }
}

TEST_F(ConstructorsTest, TheirCallsReturnTheSameInAWorker) {
  const Words flags = OnStick({"--for", "500ms"});
  const std::string results =
      "First: made at 0 ms, sent 0, asked 0, named 0, registered 0, found 12, random ";
  EXPECT_THAT(Record(flags).err, HasSubstr(results));
  EXPECT_THAT(Record(flags + kPair).err, HasSubstr(results));
}

// A request to an entry that the object lacks is refused only when the object is loaded.  The wait
// for its reply ends at once.
TEST_F(ConstructorsTest, ARefusedRequestToTheirOwnObjectEndsTheSameInAWorker) {
  stick_.Write("OPEN-R/MW/DATA/P/WRONG.TXT", "");
  const Words flags = OnStick({"--for", "500ms"});
  const RecordedRun alone = Record(flags);
  EXPECT_THAT(alone.err, HasSubstr("selector is out of range: sel=99"));
  EXPECT_THAT(alone.err, HasSubstr("First: wrong 28"));
  ExpectSameApart(alone, flags);
}

// Returns the part of `text` after the first occurrence of `word`; "" if there is none.
std::string After(const std::string& text, const std::string& word) {
  const size_t at = text.find(word);
  return at == std::string::npos ? "" : text.substr(at + word.size());
}

// First crashes after 300 ms.  In the new process First's constructor has messages that wait when
// the constructor of Second asks.
TEST_F(ConstructorsTest, ARestartedWorkerRunsThemAsTheFirstDid) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "crashes are reported by the sanitizer";
#endif
  stick_.Write("OPEN-R/MW/DATA/P/FRAGILE.TXT", "");
  for (const Words& more : {Words{}, Words{"--strict"}}) {
    const Words flags = OnStick(Words{"--for", "500ms", "--restart", "1"} + kPair + more);
    const RecordedRun one = Record(flags);
    EXPECT_EQ(one.status, 1) << one.err;
    EXPECT_THAT(one.err, Not(HasSubstr("in the name of another object")));
    const std::string again = After(one.err, "process 'pair' is back");
    EXPECT_THAT(again, HasSubstr("First: made at 304 ms, sent 0, asked 0, named 0, registered 0"));
    EXPECT_THAT(again, HasSubstr("First: heard 1, keeps 1 1, answer 3"));
    EXPECT_THAT(again, HasSubstr("Second: heard 1, keeps 1 1, answer 4"));
    const RecordedRun other = Record(flags);
    EXPECT_EQ(one.Hashes(), other.Hashes());
    EXPECT_EQ(one.recording, other.recording);
  }
}

}  // namespace
}  // namespace openr_host
