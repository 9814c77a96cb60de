// The header <istream.h> of old C++: the names of <istream> without std::.
#ifndef OPENR_COMPAT_ISTREAM_H_INCLUDED
#define OPENR_COMPAT_ISTREAM_H_INCLUDED

#include <istream>

using std::iostream;
using std::istream;
using std::ws;

#endif  // OPENR_COMPAT_ISTREAM_H_INCLUDED
