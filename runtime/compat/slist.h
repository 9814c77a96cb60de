// The header <slist.h> of old C++: `slist`, a singly linked list that the C++ standard does not
// have, outside of any namespace.
#ifndef OPENR_COMPAT_SLIST_H_INCLUDED
#define OPENR_COMPAT_SLIST_H_INCLUDED

#include <ext/slist>

using __gnu_cxx::slist;

#endif  // OPENR_COMPAT_SLIST_H_INCLUDED
