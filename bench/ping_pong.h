// The games of the message rows: two objects that send each other messages without end, and the
// same in a ring of structs, which is the floor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace openr_host {

// Passes `count` messages between two actors of a ring of structs.  A message costs one virtual
// call: nothing is looked up, ordered or counted.
void RunRing(int64_t count);

// Pairs of a subject and an observer.  The subject answers every ready with a notification of the
// same region, the observer answers every notification with a ready.
class PingPong {
 public:
  // Boots `pairs` pairs, whose regions have `bytes` bytes each.  If `traced` is true, the run also
  // computes the trace hash.
  PingPong(int pairs, size_t bytes, bool traced);
  ~PingPong();

  // Delivers `count` messages.  A notification and the ready that comes back are two messages.
  void Run(int64_t count);

 private:
  struct Game;
  const std::unique_ptr<Game> game_;
};

}  // namespace openr_host
