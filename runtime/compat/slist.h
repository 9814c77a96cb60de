// The header <slist.h> of old C++: the singly linked list from before the C++ standard, without its
// namespace.
#ifndef OPENR_COMPAT_SLIST_H_INCLUDED
#define OPENR_COMPAT_SLIST_H_INCLUDED

#include <ext/slist>

using __gnu_cxx::slist;

#endif  // OPENR_COMPAT_SLIST_H_INCLUDED
