#include "openr/inspect/snapshot_list.h"

#include <algorithm>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

// Decides which snapshots of openr replay --step (processes that wait) are removed.  Let `distance`
// be the number of messages between the two neighbours of a snapshot in the list, and `age` the
// number of messages from the later neighbour to the newest snapshot.  The snapshot is removed if
// `age` is at least kAgePerDistance times `distance`.
constexpr uint64_t kAgePerDistance = 4;

}  // namespace

std::vector<pid_t> SnapshotList::Add(const ProcessSnapshot& snapshot) {
  ASSERT(size_ == 0 || all_[size_ - 1].count < snapshot.count);
  std::vector<pid_t> removed;
  // Keeps snapshot 0, the beginning, from which every moment can be reached.
  if (size_ == kSizeMax) removed.push_back(Remove(1));
  all_[size_++] = snapshot;
  for (size_t i = 1; i + 1 < size_;) {
    const uint64_t distance = all_[i + 1].count - all_[i - 1].count;
    const uint64_t age = snapshot.count - all_[i + 1].count;
    if (distance * kAgePerDistance <= age) {
      removed.push_back(Remove(i));
    } else {
      ++i;
    }
  }
  return removed;
}

void SnapshotList::RemoveAfter(uint64_t count) {
  while (size_ > 0 && all_[size_ - 1].count > count) --size_;
}

uint64_t SnapshotList::CountBefore(int64_t time_us) const {
  uint64_t count = 0;
  for (size_t i = 0; i < size_ && all_[i].time_us < time_us; ++i) count = all_[i].count;
  return count;
}

pid_t SnapshotList::Remove(size_t index) {
  const pid_t process = all_[index].process;
  std::copy(all_ + index + 1, all_ + size_, all_ + index);
  --size_;
  return process;
}

}  // namespace openr_host
