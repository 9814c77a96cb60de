// The header <complex.h> of old C++: the names of <complex> without std::.
#ifndef OPENR_COMPAT_COMPLEX_H_INCLUDED
#define OPENR_COMPAT_COMPLEX_H_INCLUDED

#ifndef __cplusplus
#include_next <complex.h>
#else
#include <complex>

using std::complex;
#endif

#endif  // OPENR_COMPAT_COMPLEX_H_INCLUDED
