// The header <bitset.h> of old C++: the names of <bitset> without std::.
#ifndef OPENR_COMPAT_BITSET_H_INCLUDED
#define OPENR_COMPAT_BITSET_H_INCLUDED

#include <bitset>

using std::bitset;

#endif  // OPENR_COMPAT_BITSET_H_INCLUDED
