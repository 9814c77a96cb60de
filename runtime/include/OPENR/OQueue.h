// A first-in first-out queue of at most MaxSize elements.
#ifndef OPENR_OQUEUE_H_INCLUDED
#define OPENR_OQUEUE_H_INCLUDED

#include <OPENR/ODeque.h>

// A first-in first-out queue.  The type T of its elements needs a default constructor and
// assignment.
template <class T, int MaxSize>
class OQueue {
 public:
  // PushBack() returns otlOVERFLOW if the queue is full.  PopFront() returns otlUNDERFLOW if the
  // queue is empty.
  OTLStatus PushBack(const T& value) { return deque_.PushBack(value); }
  OTLStatus PopFront() { return deque_.PopFront(); }

  // Returns the oldest element; a default T if the queue is empty.
  T& Front() { return deque_.Front(); }

  void Clear() { deque_.Clear(); }
  int GetSize() const { return deque_.GetSize(); }
  int GetMaxSize() const { return MaxSize; }

 private:
  ODeque<T, MaxSize> deque_;
};

#endif  // OPENR_OQUEUE_H_INCLUDED
