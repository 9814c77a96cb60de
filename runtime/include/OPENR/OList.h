// A doubly linked list of at most MaxSize elements, which allocates no memory.
#ifndef OPENR_OLIST_H_INCLUDED
#define OPENR_OLIST_H_INCLUDED

#include <OPENR/OTLStatus.h>

// The index that means "no element" in an OList.
const int olistNULL = -1;

// A doubly linked list.  Its links are indices into an array, so a list can be copied like any
// value.  T needs a default constructor and assignment.
template <class T, int MaxSize>
class OList {
 public:
  // A reference to an element of the list, or to the place behind the last element.  Stays valid
  // until its element is removed.
  class Iterator {
   public:
    Iterator() : list_(0), node_(olistNULL) {}
    Iterator(OList* list, int node) : list_(list), node_(node) {}

    bool operator==(const Iterator& other) const { return node_ == other.node_; }
    bool operator!=(const Iterator& other) const { return node_ != other.node_; }

    // Returns the element to which this iterator refers, or a default T for the place behind the
    // last element.
    T& operator*() const { return list_->At(node_); }

    // Move to the next or previous element.  The list is a ring: after the place behind the last
    // element comes the first.
    Iterator& operator++() {
      node_ = list_->node_[node_].next;
      return *this;
    }
    Iterator& operator--() {
      node_ = list_->node_[node_].prev;
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    Iterator operator--(int) {
      const Iterator before = *this;
      --*this;
      return before;
    }

   private:
    friend class OList;
    OList* list_;
    int node_;
  };

  OList() : none_() { Clear(); }

  // Add an element at the beginning or at the end; return otlOVERFLOW if the list is full.
  OTLStatus PushFront(const T& value) { return InsertBefore(node_[END].next, value); }
  OTLStatus PushBack(const T& value) { return InsertBefore(END, value); }

  // Remove the first or the last element; return otlUNDERFLOW if the list is empty.
  OTLStatus PopFront() { return size_ == 0 ? otlUNDERFLOW : Remove(node_[END].next); }
  OTLStatus PopBack() { return size_ == 0 ? otlUNDERFLOW : Remove(node_[END].prev); }

  // Return the first or the last element.  If the list is empty, return a default T, which is not
  // part of the list.
  T& Front() { return At(node_[END].next); }
  T& Back() { return At(node_[END].prev); }

  Iterator Begin() { return Iterator(this, node_[END].next); }
  Iterator End() { return Iterator(this, END); }

  // Inserts before the element at `where`; returns otlOVERFLOW if the list is full.
  OTLStatus Insert(Iterator where, const T& value) { return InsertBefore(where.node_, value); }

  // Removes an element; returns otlFAIL for an iterator that refers to no element.
  OTLStatus Erase(Iterator where) {
    return where.node_ < 0 || where.node_ >= END ? otlFAIL : Remove(where.node_);
  }

  void Clear() {
    size_ = 0;
    node_[END].next = END;
    node_[END].prev = END;
    for (int i = 0; i < MaxSize; i++) node_[i].next = i + 1 < MaxSize ? i + 1 : olistNULL;
    free_ = 0;
  }
  int GetSize() const { return size_; }
  int GetMaxSize() const { return MaxSize; }

 private:
  // node_[END] is the place behind the last element.  It links the last element to the first, so
  // that the list is a ring.
  enum { END = MaxSize };

  struct Node {
    T value;
    int next;
    int prev;
    Node() : value(), next(olistNULL), prev(olistNULL) {}
  };

  T& At(int node) { return node == END ? none_ = T() : node_[node].value; }

  OTLStatus InsertBefore(int where, const T& value) {
    if (free_ == olistNULL) return otlOVERFLOW;
    if (where < 0 || where > END) return otlFAIL;
    const int fresh = free_;
    free_ = node_[fresh].next;
    node_[fresh].value = value;
    node_[fresh].next = where;
    node_[fresh].prev = node_[where].prev;
    node_[node_[where].prev].next = fresh;
    node_[where].prev = fresh;
    size_++;
    return otlSUCCESS;
  }

  OTLStatus Remove(int node) {
    node_[node_[node].prev].next = node_[node].next;
    node_[node_[node].next].prev = node_[node].prev;
    node_[node].next = free_;
    free_ = node;
    size_--;
    return otlSUCCESS;
  }

  Node node_[MaxSize + 1];
  int free_;  // index of the first unused node; `next` links the unused nodes
  int size_;
  T none_;
};

#endif  // OPENR_OLIST_H_INCLUDED
