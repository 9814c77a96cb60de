// The header <multimap.h> of old C++: the names of <map> without std::.
#ifndef OPENR_COMPAT_MULTIMAP_H_INCLUDED
#define OPENR_COMPAT_MULTIMAP_H_INCLUDED

#include <map>

using std::multimap;

#endif  // OPENR_COMPAT_MULTIMAP_H_INCLUDED
