// The header <fstream.h> of old C++: the names of <fstream> without std::.
#ifndef OPENR_COMPAT_FSTREAM_H_INCLUDED
#define OPENR_COMPAT_FSTREAM_H_INCLUDED

#include <iostream.h>

#include <fstream>

using std::filebuf;
using std::fstream;
using std::ifstream;
using std::ofstream;

#endif  // OPENR_COMPAT_FSTREAM_H_INCLUDED
