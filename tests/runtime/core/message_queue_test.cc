#include "runtime/core/message_queue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "runtime/core/schedule.h"

namespace openr_host {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr int kPriority = 128;

// Chooses the last of the receivers.
class LastReceiver : public Schedule {
 public:
  size_t Choose(Question, const std::vector<ObjectId>& candidates) override {
    asked.push_back(candidates);
    return candidates.size() - 1;
  }
  std::vector<std::vector<ObjectId>> asked;
};

class MessageQueueTest : public testing::Test {
 protected:
  OwnedMessage Make(uint64_t number, int64_t due_us = 0, ObjectId target = 1) {
    OwnedMessage message = queue.Allocate();
    message->number = number;
    message->due_us = due_us;
    message->sender = kNoObject;
    message->target = target;
    message->selector = 0;
    return message;
  }
  void Push(uint64_t number, int64_t due_us = 0, ObjectId target = 1, int priority = kPriority) {
    queue.Push(Make(number, due_us, target), priority);
  }
  // Takes all messages that are due, and returns their numbers.
  std::vector<uint64_t> TakeDue(Schedule* schedule = nullptr) {
    std::vector<uint64_t> numbers;
    while (const OwnedMessage message = queue.Pop(schedule)) numbers.push_back(message->number);
    return numbers;
  }
  std::vector<uint64_t> Queued() const {
    std::vector<uint64_t> numbers;
    queue.ForEach([&numbers](const Message& message) { numbers.push_back(message.number); });
    return numbers;
  }
  std::vector<uint64_t> TakeOdd() {
    std::vector<uint64_t> numbers;
    for (const OwnedMessage& message :
         queue.TakeIf([](const Message& message) { return message.number % 2 == 1; }))
      numbers.push_back(message->number);
    return numbers;
  }

  MessageQueue queue;
};

TEST_F(MessageQueueTest, AnEmptyQueueHasNoFirstMessage) {
  EXPECT_FALSE(queue.HasDue());
  EXPECT_EQ(queue.First(), nullptr);
  EXPECT_EQ(queue.NextTime(), INT64_MAX);
  EXPECT_EQ(queue.size(), 0u);
}

TEST_F(MessageQueueTest, TheFirstMessageIsTheOneThatPopTakes) {
  Push(1);
  Push(2, 0, 1, kPriority + 1);
  EXPECT_EQ(queue.First()->number, 2u);
  EXPECT_THAT(TakeDue(), ElementsAre(2, 1));
}

TEST_F(MessageQueueTest, ALevelThatHasRunEmptyHidesNoOtherMessage) {
  Push(1, 0, 1, kPriority + 1);
  EXPECT_EQ(queue.Pop()->number, 1u);
  EXPECT_FALSE(queue.HasDue());
  EXPECT_EQ(queue.size(), 0u);
  Push(2);
  EXPECT_EQ(queue.First()->number, 2u);
  EXPECT_EQ(queue.size(), 1u);
  Push(3, 0, 1, kPriority + 1);
  EXPECT_THAT(TakeDue(), ElementsAre(3, 2));
  EXPECT_EQ(queue.Pop(), nullptr);
}

TEST_F(MessageQueueTest, MessagesBecomeDueWithTheClock) {
  Push(1, 20);
  Push(2, 10);
  Push(3, 10);
  EXPECT_FALSE(queue.HasDue());
  EXPECT_EQ(queue.NextTime(), 10);
  queue.Advance(10);
  EXPECT_THAT(TakeDue(), ElementsAre(2, 3));
  EXPECT_EQ(queue.NextTime(), 20);
  queue.Advance(15);
  EXPECT_FALSE(queue.HasDue());
  Push(4, 15);
  EXPECT_THAT(TakeDue(), ElementsAre(4));
  queue.Advance(20);
  EXPECT_THAT(TakeDue(), ElementsAre(1));
}

TEST_F(MessageQueueTest, AMessageThatIsPutBackComesFirst) {
  queue.PushFront(Make(1), kPriority);
  EXPECT_EQ(queue.size(), 1u);
  Push(2);
  queue.PushFront(Make(3), kPriority);
  EXPECT_EQ(queue.size(), 3u);
  EXPECT_THAT(TakeDue(), ElementsAre(3, 1, 2));
}

TEST_F(MessageQueueTest, ForEachVisitsInTheOrderOfDelivery) {
  for (uint64_t number = 1; number <= 6; ++number) Push(number, 70 - 10 * static_cast<int>(number));
  Push(7, 10);
  Push(8);
  Push(9, 0, 1, kPriority + 1);
  EXPECT_THAT(Queued(), ElementsAre(9, 8, 6, 7, 5, 4, 3, 2, 1));
}

TEST_F(MessageQueueTest, MessagesThatAreTakenOutLeaveTheOrderOfTheOthers) {
  for (uint64_t number = 1; number <= 6; ++number) Push(number);
  for (uint64_t number = 7; number <= 12; ++number) Push(number, 20 - static_cast<int>(number));
  EXPECT_THAT(TakeOdd(), ElementsAre(1, 3, 5, testing::_, testing::_, testing::_));
  EXPECT_EQ(queue.size(), 6u);
  EXPECT_THAT(Queued(), ElementsAre(2, 4, 6, 12, 10, 8));
  Push(14);
  EXPECT_THAT(TakeDue(), ElementsAre(2, 4, 6, 14));
  EXPECT_EQ(queue.NextTime(), 8);
}

TEST_F(MessageQueueTest, TakingOutEveryMessageEmptiesTheQueue) {
  Push(1);
  Push(3, 0, 1, 0);
  Push(5, 10);
  EXPECT_THAT(TakeOdd(), ElementsAre(1, 3, 5));
  EXPECT_FALSE(queue.HasDue());
  EXPECT_EQ(queue.size(), 0u);
  EXPECT_THAT(Queued(), IsEmpty());
  Push(7);
  EXPECT_THAT(TakeDue(), ElementsAre(7));
}

TEST_F(MessageQueueTest, AScheduleChoosesAmongReceiversWithAMessageNow) {
  LastReceiver schedule;
  Push(1, 0, 5);
  Push(2, 0, 6);
  Push(3, 0, 5);
  Push(4, 0, 7, kPriority - 1);
  EXPECT_THAT(TakeDue(&schedule), ElementsAre(2, 1, 3, 4));
  EXPECT_THAT(schedule.asked, ElementsAre(ElementsAre(5, 6)));
}

TEST_F(MessageQueueTest, MessagesPushedAfterAChoiceGoToTheEnd) {
  LastReceiver schedule;
  Push(1, 0, 5);
  Push(2, 0, 6);
  EXPECT_EQ(queue.Pop(&schedule)->number, 2u);
  EXPECT_EQ(queue.size(), 1u);
  Push(3, 0, 5);
  EXPECT_THAT(TakeDue(), ElementsAre(1, 3));
}

TEST_F(MessageQueueTest, MoreMessagesThanOneChunkKeepTheirOrder) {
  std::vector<uint64_t> pushed;
  for (uint64_t number = 1; number <= 1000; ++number) {
    Push(number);
    pushed.push_back(number);
  }
  EXPECT_EQ(TakeDue(), pushed);
}

}  // namespace
}  // namespace openr_host
