// The header <exception.h> of old C++: the names of <exception> without std::.
#ifndef OPENR_COMPAT_EXCEPTION_H_INCLUDED
#define OPENR_COMPAT_EXCEPTION_H_INCLUDED

#include <exception>

using std::exception;
using std::terminate;
using std::unexpected;

#endif  // OPENR_COMPAT_EXCEPTION_H_INCLUDED
