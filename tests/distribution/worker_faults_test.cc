// What a placed process cannot do, and what becomes of it and of the run then.
#include <gmock/gmock.h>
#include <signal.h>

#include "tests/distribution/same_run.h"
#include "tests/distribution/sticks.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const Words kIdeal = {"--body", "ideal"};

// ---- 64 MB are the most in one sample

// A region of 25 MB for three observers.
TEST(WorkerFaultsTest, ARegionGoesOnceHoweverManyItIsFor) {
  const ScratchFolder stick;
  MakeBulkStick(stick);
  stick.Write("OPEN-R/MW/DATA/P/BULK.TXT", "25000000 1 1");
  const Words flags = kIdeal + Words{"--for", "1s", "--stick", stick.path()};
  ExpectSame(Record(flags), Record(flags + Isolated({"Bulk"})));
}

// Each has bytes of its own.
TEST(WorkerFaultsTest, RegionsThatAreTooMuchAreNamed) {
  const ScratchFolder stick;
  MakeBulkStick(stick);
  stick.Write("OPEN-R/MW/DATA/P/BULK.TXT", "25000000 3 1");
  const ProgramResult result = RunProgram(
      kQuickly + kIdeal + Words{"--for", "1s", "--stick", stick.path(), "--isolate", "Bulk"});
  EXPECT_EQ(result.status, 1);
  const std::string words =
      "could not send 71 MB to the run, 64 MB at once is the most: an object has to notify less in "
      "one handler, or to stay in openr run";
  EXPECT_THAT(result.err, HasSubstr("openr: process 'Bulk': " + words + "\n"));
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  EXPECT_THAT(report["processes"][0]["lost"].get<std::string>(), HasSubstr(words));
}

// ---- a handler that does not return

// It is mostly found while it speaks to the run.  Others go on until the end.
TEST(WorkerFaultsTest, AHandlerThatPrintsForEverIsNamedAsItself) {
  const ScratchFolder stick;
  stick.MakeTrouble("flood");
  const ProgramResult result =
      RunProgram(kQuickly + kIdeal +
                 Words{"--for", "1s", "--stick", stick.path(), "--isolate", "Trouble",
                       "--handler-limit", "500ms", "--console", "/dev/null"});
  EXPECT_EQ(result.status, 1);
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << result.err;
  EXPECT_EQ(report["virtual_time_s"], 1) << result.err;
  EXPECT_EQ(report["processes"][0]["lost"],
            "a handler does not return: DoStart (selector 1) has used more than 0.5 s of processor "
            "time (--handler-limit)");
}

}  // namespace
}  // namespace openr_host
