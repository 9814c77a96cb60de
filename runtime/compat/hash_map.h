// The header <hash_map.h> of old C++: `hash_map` and `hash_multimap`, which the C++ standard does
// not have, outside of any namespace.
#ifndef OPENR_COMPAT_HASH_MAP_H_INCLUDED
#define OPENR_COMPAT_HASH_MAP_H_INCLUDED

#include <ext/hash_map>

using __gnu_cxx::hash;
using __gnu_cxx::hash_map;
using __gnu_cxx::hash_multimap;

#endif  // OPENR_COMPAT_HASH_MAP_H_INCLUDED
