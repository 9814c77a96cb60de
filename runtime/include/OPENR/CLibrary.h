// Includes the headers of the C library that old sources use without including them.
//
// On the robot every OPEN-R header includes these headers, so programs use fopen, sprintf, atoi,
// malloc, sin or M_PI without an #include.
#ifndef OPENR_CLIBRARY_H_INCLUDED
#define OPENR_CLIBRARY_H_INCLUDED

#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

// Reads one line of the console.  Declared here for old programs, because the headers of the C
// library do not declare gets() for C++14 and later.
extern "C" char* gets(char* line);

// Functions that compare text without regard to upper and lower case, under the names that they
// have in newlib, the robot's C library.
inline int stricmp(const char* left, const char* right) { return strcasecmp(left, right); }
inline int strnicmp(const char* left, const char* right, size_t size) {
  return strncasecmp(left, right, size);
}

#endif  // OPENR_CLIBRARY_H_INCLUDED
