// The header <map.h> of old C++: the names of <map> without std::.
#ifndef OPENR_COMPAT_MAP_H_INCLUDED
#define OPENR_COMPAT_MAP_H_INCLUDED

#include <map>

using std::map;

#endif  // OPENR_COMPAT_MAP_H_INCLUDED
