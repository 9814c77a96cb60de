// The header <stream.h> of old C++, another name of <iostream.h>.
#ifndef OPENR_COMPAT_STREAM_H_INCLUDED
#define OPENR_COMPAT_STREAM_H_INCLUDED

#include <iostream.h>

#endif  // OPENR_COMPAT_STREAM_H_INCLUDED
