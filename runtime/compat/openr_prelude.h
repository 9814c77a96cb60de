// Includes headers for old programs that call functions without including their headers.
//
// In the SDK's library <string> also declared strlen(), and <iostream> exit(), so a missing
// #include was not noticed.  The compiler wrappers of the host kit include this header before a
// source that does not compile otherwise.
#ifndef OPENR_COMPAT_OPENR_PRELUDE_H_INCLUDED
#define OPENR_COMPAT_OPENR_PRELUDE_H_INCLUDED

#include <OPENR/CLibrary.h>
#include <assert.h>
#include <errno.h>
#include <float.h>
#include <stdarg.h>
#include <stddef.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <iterator>
#include <list>
#include <map>
#include <string>
#include <utility>
#include <vector>

// Replacements for the operators a <? b (minimum) and a >? b (maximum) of g++ 3.3, and for a <?= b
// and a >?= b, which assign the result to a.  Today's compilers do not know these operators, so
// `openr build` replaces, for example, a <? b by a <openr_old::minimum> b.  The operators < and >
// that are defined below compute the result of this expression.
namespace openr_old {

enum Minimum { minimum };
enum Maximum { maximum };
enum SetMinimum { set_minimum };
enum SetMaximum { set_maximum };

template <class Operator, class Left>
struct Pending {
  Left& left;
};

template <class Left, class Right>
struct Common {
  typedef __typeof__(true ? *(Left*)0 : *(Right*)0) Type;
};

template <class Left>
Pending<Minimum, const Left> operator<(const Left& left, Minimum) {
  Pending<Minimum, const Left> pending = {left};
  return pending;
}
template <class Left>
Pending<Maximum, const Left> operator<(const Left& left, Maximum) {
  Pending<Maximum, const Left> pending = {left};
  return pending;
}
template <class Left>
Pending<SetMinimum, Left> operator<(Left& left, SetMinimum) {
  Pending<SetMinimum, Left> pending = {left};
  return pending;
}
template <class Left>
Pending<SetMaximum, Left> operator<(Left& left, SetMaximum) {
  Pending<SetMaximum, Left> pending = {left};
  return pending;
}

template <class Left, class Right>
typename Common<Left, Right>::Type operator>(Pending<Minimum, const Left> pending,
                                             const Right& right) {
  return right < pending.left ? right : pending.left;
}
template <class Left, class Right>
typename Common<Left, Right>::Type operator>(Pending<Maximum, const Left> pending,
                                             const Right& right) {
  return pending.left < right ? right : pending.left;
}
template <class Left, class Right>
Left& operator>(Pending<SetMinimum, Left> pending, const Right& right) {
  if (right < pending.left) pending.left = right;
  return pending.left;
}
template <class Left, class Right>
Left& operator>(Pending<SetMaximum, Left> pending, const Right& right) {
  if (pending.left < right) pending.left = right;
  return pending.left;
}

}  // namespace openr_old

#endif  // OPENR_COMPAT_OPENR_PRELUDE_H_INCLUDED
