// SnapshotList: how many snapshots of a replay are kept, and how far they are apart.
#include "openr/inspect/snapshot_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace openr_host {
namespace {

using testing::IsEmpty;

// Adds the snapshot after `count` messages.  The process has the number `count`, and there is a
// message each 10 us.
std::vector<pid_t> Add(SnapshotList* list, int count) {
  return list->Add({static_cast<uint64_t>(count), int64_t{10} * count, count});
}

TEST(SnapshotListTest, TheNumberOfSnapshotsIsBounded) {
  SnapshotList list;
  size_t size_max = 0;
  for (int i = 0; i < 100'000; ++i) {
    Add(&list, i * 1000);
    size_max = std::max(size_max, list.size());
  }
  EXPECT_LT(size_max, 100u);
  EXPECT_EQ(list[0].count, 0u);
  EXPECT_EQ(list[list.size() - 1].count, 99'999'000u);
}

TEST(SnapshotListTest, DistancesAreAtMostAQuarterOfTheAge) {
  SnapshotList list;
  for (int i = 0; i < 5000; ++i) {
    Add(&list, i * 1000);
    for (size_t j = 1; j < list.size(); ++j) {
      const uint64_t distance = list[j].count - list[j - 1].count;
      const uint64_t age = i * uint64_t{1000} - list[j].count;
      ASSERT_LE(distance, std::max<uint64_t>(1000, age / 4)) << "after snapshot " << i;
    }
  }
}

TEST(SnapshotListTest, EachSnapshotIsKeptOrItsProcessIsReturnedOnce) {
  SnapshotList list;
  std::vector<pid_t> all;
  for (int i = 0; i < 3000; ++i) {
    const std::vector<pid_t> removed = Add(&list, i * 1000);
    all.insert(all.end(), removed.begin(), removed.end());
  }
  EXPECT_GT(all.size(), 2900u);
  for (size_t i = 0; i < list.size(); ++i) all.push_back(list[i].process);
  EXPECT_EQ(all.size(), 3000u);
  EXPECT_EQ(std::set<pid_t>(all.begin(), all.end()).size(), 3000u);
}

TEST(SnapshotListTest, GoingBackRemovesTheLaterSnapshots) {
  SnapshotList list;
  for (const int count : {0, 1000, 2000, 3000}) EXPECT_THAT(Add(&list, count), IsEmpty());
  list.RemoveAfter(1000);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[1].process, 1000);
  EXPECT_THAT(Add(&list, 2000), IsEmpty());
}

TEST(SnapshotListTest, ATimeLeadsToTheLastSnapshotBeforeIt) {
  SnapshotList list;
  EXPECT_EQ(list.CountBefore(5), 0u);
  for (const int count : {0, 1000, 2000}) Add(&list, count);
  EXPECT_EQ(list.CountBefore(0), 0u);
  EXPECT_EQ(list.CountBefore(10'000), 0u);  // messages of this very time may follow the snapshot
  EXPECT_EQ(list.CountBefore(10'001), 1000u);
  EXPECT_EQ(list.CountBefore(1'000'000), 2000u);
}

// Snapshots whose distances shrink quickly are never too close together for their age.
TEST(SnapshotListTest, AFullListLosesTheOldestSnapshotAfterTheFirst) {
  SnapshotList list;
  std::vector<pid_t> all;
  uint64_t count = 0;
  pid_t process = 0;
  for (double distance = 1e18; distance > 1; distance *= 0.88) {
    const std::vector<pid_t> removed = list.Add({count, 0, process++});
    all.insert(all.end(), removed.begin(), removed.end());
    count += static_cast<uint64_t>(distance);
  }
  ASSERT_EQ(list.size(), SnapshotList::kSizeMax);
  EXPECT_EQ(all.size(), static_cast<size_t>(process) - SnapshotList::kSizeMax);
  EXPECT_THAT(all, testing::Each(testing::Gt(0)));
  EXPECT_EQ(all.front(), 1);
  EXPECT_EQ(list[0].process, 0);
}

}  // namespace
}  // namespace openr_host
