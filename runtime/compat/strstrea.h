// <strstrea.h> of old C++.
#ifndef OPENR_COMPAT_STRSTREA_H_INCLUDED
#define OPENR_COMPAT_STRSTREA_H_INCLUDED

#include <strstream.h>

#endif  // OPENR_COMPAT_STRSTREA_H_INCLUDED
