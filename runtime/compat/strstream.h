// The header <strstream.h> of old C++: the names of <strstream> without std::.
#ifndef OPENR_COMPAT_STRSTREAM_H_INCLUDED
#define OPENR_COMPAT_STRSTREAM_H_INCLUDED

#include <iostream.h>

#include <strstream>

using std::istrstream;
using std::ostrstream;
using std::strstream;
using std::strstreambuf;

#endif  // OPENR_COMPAT_STRSTREAM_H_INCLUDED
