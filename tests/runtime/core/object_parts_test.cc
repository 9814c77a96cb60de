// The small classes that Object is made of.
#include <OPENR/OPENR.h>
#include <gtest/gtest.h>

#include "runtime/core/entry_names.h"
#include "runtime/core/processor_state.h"
#include "runtime/core/reply_boxes.h"
#include "tests/runtime/core/recorder.h"

namespace openr_host {
namespace {

TEST(EntryNamesTest, TheNameOfAnEntryHidesItsService) {
  EntryNames names;
  EXPECT_EQ(names.TextOf(7), "selector 7");
  names.SetService(7, "Mover.Move.Command.S");
  EXPECT_EQ(names.TextOf(7), "Mover.Move.Command.S (Control)");
  names.SetService(8, "Mover.Move.Command.O");
  EXPECT_EQ(names.TextOf(8), "Mover.Move.Command.O (Connect)");
  names.SetName(7, "Wave");
  EXPECT_EQ(names.TextOf(7), "Wave");
  EXPECT_EQ(*names.FindService(7), "Mover.Move.Command.S");
  EXPECT_EQ(names.TextOf(oentrySTOP), "DoStop");
}

TEST(ReplyBoxesTest, ACloseTellsOnceWhetherReplyEventsWait) {
  ReplyBoxes boxes;
  boxes.Open(3);
  boxes.NoteEvent(3);
  EXPECT_TRUE(boxes.Close(3));
  EXPECT_FALSE(boxes.IsOpen(3));
  EXPECT_FALSE(boxes.Close(3));
}

TEST(ReplyBoxesTest, ABoxThatIsOpenedApartKeepsTheNumberOfTheNewestBox) {
  ReplyBoxes boxes;
  boxes.Open(3);
  boxes.OpenApart(1000);
  EXPECT_TRUE(boxes.IsOpen(1000));
  EXPECT_EQ(boxes.last(), 3u);
}

TEST(ReplyBoxesDeathTest, ABoxWithoutAReplyHasNoneToTake) {
  ReplyBoxes boxes;
  boxes.Open(3);
  EXPECT_DEATH(boxes.Take(3), "woken without a reply to box 3");
}

TEST(ProcessorStateTest, AWaitForTheProcessorBeginsOnce) {
  ProcessorState processor;
  EXPECT_EQ(processor.EndStarving(), -1);
  processor.NoteStarving(5);
  processor.NoteStarving(9);
  EXPECT_EQ(processor.EndStarving(), 5);
  EXPECT_EQ(processor.starving_since_us(), -1);
}

class ObjectPartsTest : public testing::Test {
 protected:
  Log log;
  System system;
  Object& object = system.AddObject<Recorder>(0, "a", &log)->host();
};

TEST_F(ObjectPartsTest, TheQueueIsFullAtItsLimitAndKeepsItsLongest) {
  object.set_queue_max(2);
  object.NoteQueued();
  EXPECT_FALSE(object.IsQueueFull());
  object.NoteQueued();
  EXPECT_TRUE(object.IsQueueFull());
  object.NoteTaken(2);
  EXPECT_EQ(object.waiting(), 0);
  EXPECT_EQ(object.waiting_max(), 2);
  EXPECT_DEATH(object.NoteTaken(), "a has fewer waiting messages");
}

TEST_F(ObjectPartsTest, AnObjectIsReplacedOnce) {
  EXPECT_FALSE(object.is_leaving());
  object.BeginReplacement();
  EXPECT_TRUE(object.is_leaving());
  EXPECT_DEATH(object.BeginReplacement(), "a is replaced already");
}

TEST_F(ObjectPartsTest, TimeThatIsWaitedIsNoCallForTheTime) {
  object.NoteTimeCall();
  object.NoteWait(100);
  object.NoteTimeCall();
  EXPECT_EQ(object.passed_us(), 102u);
  EXPECT_EQ(object.time_calls(), 2u);
  object.NoteDelivered();
  EXPECT_EQ(object.passed_us(), 0u);
}

}  // namespace
}  // namespace openr_host
