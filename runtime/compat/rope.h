// The header <rope.h> of old C++: `rope`, a string for long texts, in the global namespace.  The
// C++ standard does not have this class.
#ifndef OPENR_COMPAT_ROPE_H_INCLUDED
#define OPENR_COMPAT_ROPE_H_INCLUDED

#include <ext/rope>

using __gnu_cxx::crope;
using __gnu_cxx::rope;
using __gnu_cxx::wrope;

#endif  // OPENR_COMPAT_ROPE_H_INCLUDED
