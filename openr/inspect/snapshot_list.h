// SnapshotList: the processes that serve as snapshots in openr replay --step (stepper.h).
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace openr_host {

// A snapshot: a process that waits, and so keeps the state of the replay at one moment.
struct ProcessSnapshot {
  uint64_t count = 0;   // number of messages before this moment
  int64_t time_us = 0;  // virtual time of this moment
  pid_t process = -1;
};

// The snapshots of openr replay --step, the oldest first.  A snapshot is a process that waits, and
// so keeps the state of the replay at one moment.  The list is in memory of a fixed size without
// pointers, because all processes of openr replay --step share it.
//
// Old snapshots are thinned out, because fork() takes longer with each ancestor that lives.  A
// snapshot is removed if its two neighbours in the list are at most n/4 messages apart, where n is
// the number of messages from the later neighbour to the newest snapshot.  So the distances between
// snapshots grow with their age, and the number of snapshots grows only with the logarithm of the
// number of messages.
class SnapshotList {
 public:
  // The greatest number of snapshots (processes that wait) in the list.  A replay of 10^9 messages,
  // with a snapshot after each 1000, needs only about 100, because old snapshots are thinned out.
  static constexpr size_t kSizeMax = 256;

  // Adds the snapshot (a process that waits) of the present moment.  Removes older snapshots that
  // are too close together, and returns their processes, which the caller must end.  Never removes
  // the first snapshot.  REQUIRES: `snapshot` is later than all others.
  std::vector<pid_t> Add(const ProcessSnapshot& snapshot);
  // Removes from the list each snapshot that was made after more than `count` messages.
  void RemoveAfter(uint64_t count);

  // Finds the last snapshot that is earlier than the virtual time `time_us`, and returns the number
  // of messages before this snapshot.  Returns 0 if there is no such snapshot.
  uint64_t CountBefore(int64_t time_us) const;
  size_t size() const { return size_; }
  const ProcessSnapshot& operator[](size_t index) const { return all_[index]; }

 private:
  // Removes the snapshot `index` from the list, and returns the process that waited for this
  // snapshot.
  pid_t Remove(size_t index);

  size_t size_ = 0;
  ProcessSnapshot all_[kSizeMax];
};

}  // namespace openr_host
