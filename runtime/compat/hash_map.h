// The header <hash_map.h> of old C++: `hash_map` and `hash_multimap` in the global namespace.  The
// C++ standard does not have these names.
#ifndef OPENR_COMPAT_HASH_MAP_H_INCLUDED
#define OPENR_COMPAT_HASH_MAP_H_INCLUDED

#include <ext/hash_map>

using __gnu_cxx::hash;
using __gnu_cxx::hash_map;
using __gnu_cxx::hash_multimap;

#endif  // OPENR_COMPAT_HASH_MAP_H_INCLUDED
