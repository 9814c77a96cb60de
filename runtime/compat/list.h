// The header <list.h> of old C++: the names of <list> without std::.
#ifndef OPENR_COMPAT_LIST_H_INCLUDED
#define OPENR_COMPAT_LIST_H_INCLUDED

#include <list>

using std::list;

#endif  // OPENR_COMPAT_LIST_H_INCLUDED
