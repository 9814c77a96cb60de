// The header <set.h> of old C++: the names of <set> without std::.
#ifndef OPENR_COMPAT_SET_H_INCLUDED
#define OPENR_COMPAT_SET_H_INCLUDED

#include <set>

using std::set;

#endif  // OPENR_COMPAT_SET_H_INCLUDED
