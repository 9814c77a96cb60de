// <stream.h> of old C++.
#ifndef OPENR_COMPAT_STREAM_H_INCLUDED
#define OPENR_COMPAT_STREAM_H_INCLUDED

#include <iostream.h>

#endif  // OPENR_COMPAT_STREAM_H_INCLUDED
