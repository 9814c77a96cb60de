// The class of the SDK's library that maps regions of other objects for OObserver.  Here it is
// empty, because programs only name it.
#ifndef OPENR_MEMORYMAPAGENT_H_INCLUDED
#define OPENR_MEMORYMAPAGENT_H_INCLUDED

#include <OPENR/RCRegion.h>

#include <map>

using std::less;
using std::map;

class MemoryMapAgent {};

#endif  // OPENR_MEMORYMAPAGENT_H_INCLUDED
