// Tests of the report about objects that wait for an answer or for the processor.
#include "runtime/core/stalls.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/core/recorder.h"

namespace openr_host {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> TextsOf(const System& system, int64_t least_us) {
  std::vector<std::string> texts;
  for (const Stall& stall : FindStalls(system, least_us)) texts.push_back(stall.text);
  return texts;
}

TEST(StallsTest, ACallWithoutAnswerIsOneAfterASecond) {
  Log log;
  System system;
  system.AddRobot("ERS-210", nullptr);
  Recorder* const caller = system.AddObject<Recorder>(0, "caller", &log);
  Recorder* const callee = system.AddObject<Recorder>(0, "callee", &log);
  caller->on_message = [&](int) {
    int answer = 0;
    system.requests().Call(callee->host().id, callee->entry, &answer, sizeof answer, &answer,
                           sizeof answer);
  };
  PostTo(caller, 1);
  system.RunFor(999'000);
  EXPECT_THAT(TextsOf(system, 0),
              ElementsAre("caller waits for the answer of callee (Entry) since t=0.000 s"));
  EXPECT_TRUE(TextsOf(system, kStallUs).empty());
  system.RunFor(1'000);
  ReportStalls(&system, false);
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_THAT(system.findings().all()[0].text, HasSubstr("two objects that Call() each other"));
}

// The receiver waits for more data; the sender does not wait for a ready of the receiver.
TEST(StallsTest, AnObserverThatIsReadyForSeveralNotificationsInOneMessageIsNone) {
  System system;
  system.AddRobot("ERS-210", nullptr);
  SubjectProbe* const sender = system.AddObject<SubjectProbe>(0, "sender");
  ObserverProbe* const receiver = system.AddObject<ObserverProbe>(0, "receiver");
  RunAs(receiver, [&] { receiver->in->SetBufCtrlParam(0, 2, 4); });
  receiver->on_start = [&] { receiver->in->AssertReady(); };
  system.Connect({0, "Sender.Out.Number.S", "Receiver.In.Number.O", "test"});
  system.Boot();
  system.RunFor(1000);
  RunAs(sender, [&] { sender->Send(1); });
  system.RunFor(2 * kStallUs);
  EXPECT_TRUE(receiver->events.empty());
  EXPECT_TRUE(TextsOf(system, 0).empty());
  ReportStalls(&system, true);
  EXPECT_TRUE(system.findings().all().empty());
}

// The one called "hog" costs 1 ms, everybody else 1 us.
class HogCost : public CostModel {
 public:
  int64_t CostUs(const Object& object, uint32_t) override {
    return object.name == "hog" ? 1000 : 1;
  }
};

TEST(StallsTest, AnObjectWithoutProcessorIsOneAndAFindingOnceItRuns) {
  Log log;
  System system({.cost = std::make_shared<HogCost>()});
  system.AddRobot("ERS-210", nullptr);
  Recorder* const hog = system.AddObject<Recorder>(0, "hog", &log);
  Recorder* const meek = system.AddObject<Recorder>(0, "meek", &log);
  hog->host().set_priority(144);
  hog->on_message = [&](int left) {
    if (left > 0) PostTo(hog, left - 1);
  };
  PostTo(hog, 1500);
  PostTo(meek, 1, 10);
  system.RunFor(1'200'000);
  EXPECT_THAT(TextsOf(system, kStallUs),
              ElementsAre("meek waits for the processor since t=0.000 s"));
  EXPECT_TRUE(system.findings().all().empty());
  system.RunFor(1'000'000);
  EXPECT_TRUE(TextsOf(system, 0).empty());
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_EQ(system.findings().all()[0].object, "meek");
  EXPECT_THAT(system.findings().all()[0].text, HasSubstr("got no processor time for 1.50"));
}

// "long" takes what it is told to.
class ToldCost : public CostModel {
 public:
  explicit ToldCost(int64_t cost_us) : cost_us_(cost_us) {}
  int64_t CostUs(const Object&, uint32_t) override { return cost_us_; }

 private:
  const int64_t cost_us_;
};

std::vector<std::string> FindingsWithHandlersOf(int64_t cost_us) {
  Log log;
  System system({.cost = std::make_shared<ToldCost>(cost_us)});
  system.AddRobot("ERS-210", nullptr);
  PostTo(system.AddObject<Recorder>(0, "worker", &log), 1);
  system.RunFor(100'000);
  std::vector<std::string> texts;
  for (const Finding& finding : system.findings().all())
    texts.push_back(finding.object + ": " + finding.text);
  return texts;
}

TEST(StallsTest, AHandlerThatTakesLongerThanASensorPeriodIsReported) {
  EXPECT_TRUE(FindingsWithHandlersOf(32'000).empty());
  EXPECT_THAT(FindingsWithHandlersOf(32'001),
              ElementsAre(testing::HasSubstr("takes longer than the 32 ms between two sensor "
                                             "vectors: this object loses some")));
}

}  // namespace
}  // namespace openr_host
