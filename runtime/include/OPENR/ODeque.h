// A double-ended queue of at most MaxSize elements, which allocates no memory.
#ifndef OPENR_ODEQUE_H_INCLUDED
#define OPENR_ODEQUE_H_INCLUDED

#include <OPENR/OTLStatus.h>

// A double-ended queue.  The type T of its elements needs a default constructor and assignment.
template <class T, int MaxSize>
class ODeque {
 public:
  ODeque() : element_(), start_(0), size_(0), none_() {}

  // Add an element at the end or at the beginning; return otlOVERFLOW if the queue is full.
  OTLStatus PushBack(const T& value) {
    if (size_ == MaxSize) return otlOVERFLOW;
    element_[Place(size_)] = value;
    size_++;
    return otlSUCCESS;
  }
  OTLStatus PushFront(const T& value) {
    if (size_ == MaxSize) return otlOVERFLOW;
    start_ = Place(MaxSize - 1);
    element_[start_] = value;
    size_++;
    return otlSUCCESS;
  }

  // Remove the first or the last element; return otlUNDERFLOW if the queue is empty.
  OTLStatus PopFront() {
    if (size_ == 0) return otlUNDERFLOW;
    start_ = Place(1);
    size_--;
    return otlSUCCESS;
  }
  OTLStatus PopBack() {
    if (size_ == 0) return otlUNDERFLOW;
    size_--;
    return otlSUCCESS;
  }

  // Return the first or the last element.  If the queue is empty, return a default T, which is not
  // part of the queue.
  T& Front() { return size_ == 0 ? None() : element_[start_]; }
  T& Back() { return size_ == 0 ? None() : element_[Place(size_ - 1)]; }

  void Clear() { size_ = 0; }
  int GetSize() const { return size_; }
  int GetMaxSize() const { return MaxSize; }

 private:
  // Returns the index in element_ that is `distance` places behind start_, the index of the first
  // element.
  int Place(int distance) const { return (start_ + distance) % MaxSize; }
  T& None() { return none_ = T(); }

  T element_[MaxSize];
  int start_;
  int size_;
  T none_;
};

#endif  // OPENR_ODEQUE_H_INCLUDED
