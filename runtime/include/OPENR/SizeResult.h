// Results of type size_t that a program takes in an unsigned int.
//
// On the robot both are one type, so a program may hand either to a size_t*.  Where size_t is
// wider, the functions concerned have a second form for unsigned int*, which uses these.  It is a
// template, so that a literal 0 finds the first form.
#ifndef OPENR_SIZERESULT_H_INCLUDED
#define OPENR_SIZERESULT_H_INCLUDED

#include <stddef.h>

#if defined(__SIZEOF_SIZE_T__) && __SIZEOF_SIZE_T__ > __SIZEOF_INT__
#define OPENR_WIDE_SIZE 1

namespace openr_host {

// Has a Type for Number = unsigned int only.
template <class Number, class Result>
struct IfUnsigned {};
template <class Result>
struct IfUnsigned<unsigned int, Result> {
  typedef Result Type;
};

// A size_t for the duration of a call; its value goes to `number` afterwards.
class SizeResult {
 public:
  explicit SizeResult(unsigned int* number) : number_(number), size_(number == 0 ? 0 : *number) {}
  ~SizeResult() {
    if (number_ != 0) *number_ = static_cast<unsigned int>(size_);
  }
  operator size_t*() { return number_ == 0 ? 0 : &size_; }

 private:
  SizeResult(const SizeResult&);
  SizeResult& operator=(const SizeResult&);

  unsigned int* number_;
  size_t size_;
};

}  // namespace openr_host

#else
#define OPENR_WIDE_SIZE 0
#endif

#endif  // OPENR_SIZERESULT_H_INCLUDED
