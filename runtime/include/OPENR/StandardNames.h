// The names of the C++ library that old sources use without std::.
//
// On the robot the headers of inter-object communication bring them into the global namespace,
// and programs that include one of these rely on it.  `map` and `less` come with MemoryMapAgent.h
// only: a program that does not include OObserver.h may have its own.
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
