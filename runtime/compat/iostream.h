// The header <iostream.h> of old C++: the names of <iostream> without std::.
#ifndef OPENR_COMPAT_IOSTREAM_H_INCLUDED
#define OPENR_COMPAT_IOSTREAM_H_INCLUDED

#include <istream.h>
#include <ostream.h>
#include <streambuf.h>

#include <iostream>

using std::cerr;
using std::cin;
using std::clog;
using std::cout;
using std::dec;
using std::hex;
using std::ios;
using std::oct;
using std::streamoff;
using std::streampos;

#endif  // OPENR_COMPAT_IOSTREAM_H_INCLUDED
