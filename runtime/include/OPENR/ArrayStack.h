// A last-in first-out stack that allocates its memory once.
//
// The SDK's libraries use such a class; only its name is known, so the functions are our choice.
#ifndef OPENR_ARRAYSTACK_H_INCLUDED
#define OPENR_ARRAYSTACK_H_INCLUDED

#include <OPENR/OTLStatus.h>

template <class T>
class ArrayStack {
 public:
  // Makes an empty stack for at most maxSize elements.  REQUIRES: maxSize > 0.
  explicit ArrayStack(int maxSize) : element_(new T[maxSize]), max_size_(maxSize), size_(0) {}
  ~ArrayStack() { delete[] element_; }

  // Puts `value` on the top.  Returns otlOVERFLOW if the stack is full.
  OTLStatus Push(const T& value) {
    if (size_ == max_size_) return otlOVERFLOW;
    element_[size_++] = value;
    return otlSUCCESS;
  }
  // Removes the element on the top.  Returns otlUNDERFLOW if the stack is empty.
  OTLStatus Pop() {
    if (size_ == 0) return otlUNDERFLOW;
    size_--;
    return otlSUCCESS;
  }
  // Returns the element on the top, which was pushed last.  REQUIRES: GetSize() > 0.
  T& Top() { return element_[size_ - 1]; }

  void Clear() { size_ = 0; }
  int GetSize() const { return size_; }
  int GetMaxSize() const { return max_size_; }

 private:
  ArrayStack(const ArrayStack&);
  ArrayStack& operator=(const ArrayStack&);

  T* element_;
  int max_size_;
  int size_;
};

#endif  // OPENR_ARRAYSTACK_H_INCLUDED
