// Lets programs pass an unsigned int* to a function that stores a result of type size_t.
//
// On the robot unsigned int is the same type as size_t, so programs pass a pointer to either type.
// Where size_t is wider, such a function has a second form for unsigned int*, which uses the
// classes below.  The second form is a template: two plain functions would make a call with a
// literal 0 ambiguous, but with a template this call selects the first form.
#ifndef OPENR_SIZERESULT_H_INCLUDED
#define OPENR_SIZERESULT_H_INCLUDED

#include <stddef.h>

#if defined(__SIZEOF_SIZE_T__) && __SIZEOF_SIZE_T__ > __SIZEOF_INT__
#define OPENR_WIDE_SIZE 1

namespace openr_host {

// Has a member Type only if Number is unsigned int; Type is then Result.  A function template that
// returns this Type therefore accepts only an unsigned int* for its result.
template <class Number, class Result>
struct IfUnsigned {};
template <class Result>
struct IfUnsigned<unsigned int, Result> {
  typedef Result Type;
};

// The size_t in which a function stores its result if the caller has passed an unsigned int*.  The
// destructor copies the size_t to `number`, the caller's unsigned int.
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
