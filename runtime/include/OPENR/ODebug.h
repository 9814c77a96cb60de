// Macros for print statements that are compiled only if OPENR_DEBUG is defined.  Arguments are in
// double parentheses: DPRINTF(("%d\n", n));
#ifndef OPENR_ODEBUG_H_INCLUDED
#define OPENR_ODEBUG_H_INCLUDED

#include <stdio.h>

#ifdef OPENR_NO_DEBUG
#undef OPENR_DEBUG
#endif

// Prints its arguments always, even if OPENR_DEBUG is not defined.
#define PRINTF(x) (printf x)

#ifdef OPENR_DEBUG
#define ODEBUG(x) (x)
#define DPRINTF(x) (printf x)
#define DPRINTF2(c, y) \
  {                    \
    if (c) (printf y); \
  }
#else
#define ODEBUG(x)
#define DPRINTF(x)
#define DPRINTF2(c, y)
#endif

#endif  // OPENR_ODEBUG_H_INCLUDED
