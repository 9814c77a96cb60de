// The header <hash_set.h> of old C++: `hash_set` and `hash_multiset` in the global namespace.  The
// C++ standard does not have these names.
#ifndef OPENR_COMPAT_HASH_SET_H_INCLUDED
#define OPENR_COMPAT_HASH_SET_H_INCLUDED

#include <ext/hash_set>

using __gnu_cxx::hash;
using __gnu_cxx::hash_multiset;
using __gnu_cxx::hash_set;

#endif  // OPENR_COMPAT_HASH_SET_H_INCLUDED
