// The part of the library that maps the regions of other objects.  It does its work within
// OObserver; a program can name it and nothing more.
#ifndef OPENR_MEMORYMAPAGENT_H_INCLUDED
#define OPENR_MEMORYMAPAGENT_H_INCLUDED

#include <OPENR/RCRegion.h>

#include <map>

using std::less;
using std::map;

class MemoryMapAgent {};

#endif  // OPENR_MEMORYMAPAGENT_H_INCLUDED
