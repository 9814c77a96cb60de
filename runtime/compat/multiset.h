// The header <multiset.h> of old C++: the names of <set> without std::.
#ifndef OPENR_COMPAT_MULTISET_H_INCLUDED
#define OPENR_COMPAT_MULTISET_H_INCLUDED

#include <set>

using std::multiset;

#endif  // OPENR_COMPAT_MULTISET_H_INCLUDED
