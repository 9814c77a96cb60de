// Declares the names of the C++ library that old sources use without std::.
//
// On the robot the headers for subjects and observers put these names into the global namespace,
// and programs that include such a header rely on that.  The names `map` and `less` are not here
// but in MemoryMapAgent.h.  Only OObserver.h includes that header, so a program without OObserver.h
// may define `map` and `less` itself.
#ifndef OPENR_STANDARDNAMES_H_INCLUDED
#define OPENR_STANDARDNAMES_H_INCLUDED

#include <string.h>

#include <iostream>
#include <list>

using std::cout;
using std::endl;
using std::list;
using std::ostream;

#endif  // OPENR_STANDARDNAMES_H_INCLUDED
