#include <OPENR/ArrayStack.h>
#include <OPENR/ODeque.h>
#include <OPENR/OList.h>
#include <OPENR/OPair.h>
#include <OPENR/OQueue.h>
#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <vector>

namespace {

template <int N>
std::vector<int> Content(OList<int, N>& list) {
  std::vector<int> content;
  for (typename OList<int, N>::Iterator it = list.Begin(); it != list.End(); ++it) {
    content.push_back(*it);
  }
  return content;
}

using Ints = std::vector<int>;

TEST(OListTest, PushAndPopWorkAtBothEnds) {
  OList<int, 4> list;
  list.PushBack(2);
  list.PushBack(3);
  list.PushFront(1);
  EXPECT_EQ(Content(list), (Ints{1, 2, 3}));
  EXPECT_EQ(list.Front(), 1);
  EXPECT_EQ(list.Back(), 3);
  EXPECT_EQ(list.PopFront(), otlSUCCESS);
  EXPECT_EQ(list.PopBack(), otlSUCCESS);
  EXPECT_EQ(Content(list), Ints{2});
}

TEST(OListTest, AFullListRefusesAndKeepsItsContent) {
  OList<int, 2> list;
  list.PushBack(1);
  list.PushBack(2);
  EXPECT_EQ(list.PushBack(3), otlOVERFLOW);
  EXPECT_EQ(list.PushFront(3), otlOVERFLOW);
  EXPECT_EQ(list.Insert(list.Begin(), 3), otlOVERFLOW);
  EXPECT_EQ(Content(list), (Ints{1, 2}));
}

TEST(OListTest, AnEmptyListHasNothingToPopAndADefaultFront) {
  OList<int, 2> list;
  EXPECT_EQ(list.PopFront(), otlUNDERFLOW);
  EXPECT_EQ(list.PopBack(), otlUNDERFLOW);
  list.Front() = 7;
  EXPECT_EQ(list.Front(), 0);
  EXPECT_EQ(list.Back(), 0);
  EXPECT_EQ(list.GetSize(), 0);
}

TEST(OListTest, InsertGoesBeforeTheElementAndBeforeTheEnd) {
  OList<int, 4> list;
  list.PushBack(1);
  list.PushBack(3);
  OList<int, 4>::Iterator second = list.Begin();
  second++;
  EXPECT_EQ(list.Insert(second, 2), otlSUCCESS);
  EXPECT_EQ(list.Insert(list.End(), 4), otlSUCCESS);
  EXPECT_EQ(Content(list), (Ints{1, 2, 3, 4}));
}

TEST(OListTest, ErasedRoomCanBeUsedAgain) {
  OList<int, 2> list;
  for (int round = 0; round < 5; ++round) {
    EXPECT_EQ(list.PushBack(round), otlSUCCESS);
    EXPECT_EQ(list.PushBack(round + 10), otlSUCCESS);
    EXPECT_EQ(list.Erase(list.Begin()), otlSUCCESS);
    EXPECT_EQ(Content(list), Ints{round + 10});
    EXPECT_EQ(list.PopBack(), otlSUCCESS);
  }
}

TEST(OListTest, TheEndCannotBeErased) {
  OList<int, 2> list;
  list.PushBack(1);
  EXPECT_EQ(list.Erase(list.End()), otlFAIL);
  EXPECT_EQ((list.Erase(OList<int, 2>::Iterator())), otlFAIL);
  EXPECT_EQ(list.GetSize(), 1);
}

TEST(OListTest, IteratorsGoBackwardsFromTheEnd) {
  OList<int, 3> list;
  list.PushBack(1);
  list.PushBack(2);
  OList<int, 3>::Iterator it = list.End();
  EXPECT_EQ(*--it, 2);
  it--;
  EXPECT_TRUE(it == list.Begin());
}

TEST(OListTest, ACopyIsIndependent) {
  OList<std::string, 3> list;
  list.PushBack("a");
  OList<std::string, 3> copy = list;
  copy.PushBack("b");
  *copy.Begin() = "c";
  EXPECT_EQ(list.GetSize(), 1);
  EXPECT_EQ(list.Front(), "a");
  EXPECT_EQ(copy.Front(), "c");
}

TEST(OListTest, ClearEmptiesAndGivesAllRoomBack) {
  OList<int, 3> list;
  for (int i = 0; i < 3; ++i) list.PushBack(i);
  list.Clear();
  EXPECT_EQ(list.GetSize(), 0);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(list.PushFront(i), otlSUCCESS);
  EXPECT_EQ(Content(list), (Ints{2, 1, 0}));
  EXPECT_EQ(list.GetMaxSize(), 3);
}

// Compares with the standard container in 2000 steps, which a fixed recurrence chooses.
TEST(ODequeTest, BehavesLikeAStandardDequeOfLimitedSize) {
  ODeque<int, 5> deque;
  std::deque<int> model;
  unsigned random = 1;
  for (int step = 0; step < 2000; ++step) {
    random = random * 1664525u + 1013904223u;
    const bool full = model.size() == 5, empty = model.empty();
    switch (random >> 30) {
      case 0:
        ASSERT_EQ(deque.PushBack(step), full ? otlOVERFLOW : otlSUCCESS);
        if (!full) model.push_back(step);
        break;
      case 1:
        ASSERT_EQ(deque.PushFront(step), full ? otlOVERFLOW : otlSUCCESS);
        if (!full) model.push_front(step);
        break;
      case 2:
        ASSERT_EQ(deque.PopBack(), empty ? otlUNDERFLOW : otlSUCCESS);
        if (!empty) model.pop_back();
        break;
      default:
        ASSERT_EQ(deque.PopFront(), empty ? otlUNDERFLOW : otlSUCCESS);
        if (!empty) model.pop_front();
    }
    ASSERT_EQ(deque.GetSize(), static_cast<int>(model.size()));
    ASSERT_EQ(deque.Front(), model.empty() ? 0 : model.front());
    ASSERT_EQ(deque.Back(), model.empty() ? 0 : model.back());
  }
}

TEST(OQueueTest, GivesBackInTheOrderOfPushing) {
  OQueue<int, 2> queue;
  EXPECT_EQ(queue.PushBack(1), otlSUCCESS);
  EXPECT_EQ(queue.PushBack(2), otlSUCCESS);
  EXPECT_EQ(queue.PushBack(3), otlOVERFLOW);
  EXPECT_EQ(queue.Front(), 1);
  EXPECT_EQ(queue.PopFront(), otlSUCCESS);
  EXPECT_EQ(queue.Front(), 2);
  queue.Clear();
  EXPECT_EQ(queue.PopFront(), otlUNDERFLOW);
  EXPECT_EQ(queue.GetMaxSize(), 2);
}

TEST(ArrayStackTest, GivesBackInReverseOrder) {
  ArrayStack<int> stack(2);
  EXPECT_EQ(stack.Pop(), otlUNDERFLOW);
  EXPECT_EQ(stack.Push(1), otlSUCCESS);
  EXPECT_EQ(stack.Push(2), otlSUCCESS);
  EXPECT_EQ(stack.Push(3), otlOVERFLOW);
  EXPECT_EQ(stack.Top(), 2);
  EXPECT_EQ(stack.Pop(), otlSUCCESS);
  EXPECT_EQ(stack.Top(), 1);
}

TEST(OPairTest, HoldsTwoValues) {
  const OPair<int, std::string> pair(1, "one");
  EXPECT_EQ(pair.first, 1);
  EXPECT_EQ(pair.second, "one");
  EXPECT_EQ((OPair<int, int>().second), 0);
}

}  // namespace
