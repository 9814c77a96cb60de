// The header <numeric.h> of old C++: the names of <numeric> without std::.
#ifndef OPENR_COMPAT_NUMERIC_H_INCLUDED
#define OPENR_COMPAT_NUMERIC_H_INCLUDED

#include <numeric>

using std::accumulate;
using std::adjacent_difference;
using std::inner_product;
using std::partial_sum;

#endif  // OPENR_COMPAT_NUMERIC_H_INCLUDED
