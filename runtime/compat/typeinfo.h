// The header <typeinfo.h> of old C++: the names of <typeinfo> without std::.
#ifndef OPENR_COMPAT_TYPEINFO_H_INCLUDED
#define OPENR_COMPAT_TYPEINFO_H_INCLUDED

#include <typeinfo>

using std::bad_cast;
using std::bad_typeid;
using std::type_info;

#endif  // OPENR_COMPAT_TYPEINFO_H_INCLUDED
