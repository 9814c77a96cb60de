// The header <new.h> of old C++: the names of <new> without std::.
#ifndef OPENR_COMPAT_NEW_H_INCLUDED
#define OPENR_COMPAT_NEW_H_INCLUDED

#include <new>

using std::bad_alloc;
using std::new_handler;
using std::nothrow;
using std::nothrow_t;
using std::set_new_handler;

#endif  // OPENR_COMPAT_NEW_H_INCLUDED
