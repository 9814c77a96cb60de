// The header <streambuf.h> of old C++: the names of <streambuf> without std::.
#ifndef OPENR_COMPAT_STREAMBUF_H_INCLUDED
#define OPENR_COMPAT_STREAMBUF_H_INCLUDED

#include <streambuf>

using std::streambuf;

#endif  // OPENR_COMPAT_STREAMBUF_H_INCLUDED
