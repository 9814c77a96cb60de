// The header <pair.h> of old C++: the names of <utility> without std::.
#ifndef OPENR_COMPAT_PAIR_H_INCLUDED
#define OPENR_COMPAT_PAIR_H_INCLUDED

#include <utility>

using std::make_pair;
using std::pair;

#endif  // OPENR_COMPAT_PAIR_H_INCLUDED
