// The header <strstrea.h> of old C++, the name of <strstream.h> on systems with 8.3 names.
#ifndef OPENR_COMPAT_STRSTREA_H_INCLUDED
#define OPENR_COMPAT_STRSTREA_H_INCLUDED

#include <strstream.h>

#endif  // OPENR_COMPAT_STRSTREA_H_INCLUDED
