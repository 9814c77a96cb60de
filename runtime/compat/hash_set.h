// The header <hash_set.h> of old C++: the hash sets from before the C++ standard, without their
// namespace.
#ifndef OPENR_COMPAT_HASH_SET_H_INCLUDED
#define OPENR_COMPAT_HASH_SET_H_INCLUDED

#include <ext/hash_set>

using __gnu_cxx::hash;
using __gnu_cxx::hash_multiset;
using __gnu_cxx::hash_set;

#endif  // OPENR_COMPAT_HASH_SET_H_INCLUDED
