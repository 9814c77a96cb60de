// The header <algobase.h> of old C++: the names of <algorithm> without std::.
#ifndef OPENR_COMPAT_ALGOBASE_H_INCLUDED
#define OPENR_COMPAT_ALGOBASE_H_INCLUDED

#include <algorithm>

using std::copy;
using std::copy_backward;
using std::equal;
using std::fill;
using std::fill_n;
using std::iter_swap;
using std::lexicographical_compare;
using std::max;
using std::min;
using std::mismatch;
using std::swap;

#endif  // OPENR_COMPAT_ALGOBASE_H_INCLUDED
