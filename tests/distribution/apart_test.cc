// Runs the conformance tests once more, with Teller and Hearer each in a worker of its own.
#include <unistd.h>

#include <set>

#include "distribution/worker_group.h"
#include "tests/conformance/conform_fixture.h"

namespace openr_host {
namespace {

class TwoProcesses : public Elsewhere {
 public:
  explicit TwoProcesses(const std::string& stick) : workers_(OptionsFor(stick)) {}
  ~TwoProcesses() override { workers_.End(); }
  StandIns StandInsFor(System* system) override { return workers_.StandInsFor(system, 0); }
  void Connect() override {
    EXPECT_EQ(workers_.Connect(), "");
    std::set<int64_t> processes = {getpid()};
    for (const WorkerGroup::ProcessFacts& process : workers_.Describe())
      processes.insert(process.pid);
    EXPECT_EQ(processes.size(), 3u) << "the objects are here";
  }

 private:
  static WorkerGroupOptions OptionsFor(const std::string& stick) {
    static int number = 0;
    WorkerGroupOptions options;
    options.bus.run = "apart-" + std::to_string(getpid()) + "-" + std::to_string(++number);
    options.placement.process_of = {{"teller", "acting"}, {"hearer", "hearing"}};
    options.stick = stick;
    options.command = {OPENR_PROGRAM, "join",         "--child-of", std::to_string(getpid()),
                       "--run-name",  options.bus.run};
    options.say = [](const std::string&) {};
    return options;
  }

  WorkerGroup workers_;
};

[[maybe_unused]] const bool kApart = [] {
  make_elsewhere = [](const std::filesystem::path& stick) -> std::unique_ptr<Elsewhere> {
    return std::make_unique<TwoProcesses>(stick);
  };
  here_only = {
      // A crash in a worker is not one of this process; faults_test.cc tests it.
      "DataReadAfterAssertReadyCrashInTheCheckingMode",
      "WritingToReceivedDataCrashesInTheCheckingMode",
      "StrictlyWritingToReceivedDataCrashes",
      // These sticks lack the placed objects, or are changed without the run's knowledge.
      "AnObjectThatIsNotInObjectCfgIsNotFound",
      "AWriteProtectedStickRefusesWritersAndSaysSo",
      "AWriteProtectedStickIsNamedForEachFileThatIsNotWritten",
      "AWriteProtectedStickKeepsAFileThatIsOpenedWithTruncOnly",
      // Only images that were loaded in this process can be loaded again.
      "AReaderThatWasReloadedUsesNoMemoryOfTheRobot",
      // The limit for the size of files is one of this process.
      "BytesThatTheStickDoesNotTakeAreReportedOnceForEachFile",
      "BytesOfAStreamThatForgetsItsErrorsAreReportedToo",
      // In workers, an observer that never asserts ready is not named, and of two objects of one
      // name both are replaced by stand-ins.
      "AnObserverThatNeverAssertsIsNamed",
      "TwoObjectsOfOneNameAreRefused",
      "ADoStartThatDoesNotReturnIsReportedWithError28",
      "ADoStopThatDoesNotReturnIsReportedAndThePowerStillGoes",
  };
  return true;
}();

}  // namespace
}  // namespace openr_host
