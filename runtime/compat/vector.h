// The header <vector.h> of old C++: the names of <vector> without std::.
#ifndef OPENR_COMPAT_VECTOR_H_INCLUDED
#define OPENR_COMPAT_VECTOR_H_INCLUDED

#include <vector>

using std::vector;

#endif  // OPENR_COMPAT_VECTOR_H_INCLUDED
