// The header <iomanip.h> of old C++: the names of <iomanip> without std::.
#ifndef OPENR_COMPAT_IOMANIP_H_INCLUDED
#define OPENR_COMPAT_IOMANIP_H_INCLUDED

#include <iostream.h>

#include <iomanip>

using std::resetiosflags;
using std::setbase;
using std::setfill;
using std::setiosflags;
using std::setprecision;
using std::setw;

#endif  // OPENR_COMPAT_IOMANIP_H_INCLUDED
