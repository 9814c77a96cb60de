// The header <slist.h> of old C++: `slist`, a singly linked list, in the global namespace.  The C++
// standard does not have this class.
#ifndef OPENR_COMPAT_SLIST_H_INCLUDED
#define OPENR_COMPAT_SLIST_H_INCLUDED

#include <ext/slist>

using __gnu_cxx::slist;

#endif  // OPENR_COMPAT_SLIST_H_INCLUDED
