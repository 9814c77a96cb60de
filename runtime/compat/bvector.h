// The header <bvector.h> of old C++: the names of <vector> without std::.
#ifndef OPENR_COMPAT_BVECTOR_H_INCLUDED
#define OPENR_COMPAT_BVECTOR_H_INCLUDED

#include <vector>

typedef std::vector<bool> bit_vector;
using std::vector;

#endif  // OPENR_COMPAT_BVECTOR_H_INCLUDED
