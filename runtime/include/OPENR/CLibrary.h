// The C library as old sources expect to find it.
//
// On the robot any OPEN-R header brings these along, and programs call fopen, sprintf,
// atoi, malloc, sin or M_PI without including anything for them.
#ifndef OPENR_CLIBRARY_H_INCLUDED
#define OPENR_CLIBRARY_H_INCLUDED

#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

// Removed from C++14, present in every C library we meet.  It reads one console line.
extern "C" char* gets(char* line);

// newlib's names for comparing text without regard to case.
inline int stricmp(const char* left, const char* right) { return strcasecmp(left, right); }
inline int strnicmp(const char* left, const char* right, size_t size) {
  return strncasecmp(left, right, size);
}

#endif  // OPENR_CLIBRARY_H_INCLUDED
