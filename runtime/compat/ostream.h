// The header <ostream.h> of old C++: the names of <ostream> without std::.
#ifndef OPENR_COMPAT_OSTREAM_H_INCLUDED
#define OPENR_COMPAT_OSTREAM_H_INCLUDED

#include <ostream>

using std::endl;
using std::ends;
using std::flush;
using std::ostream;

#endif  // OPENR_COMPAT_OSTREAM_H_INCLUDED
