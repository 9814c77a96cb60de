// The header <heap.h> of old C++: the names of <algorithm> without std::.
#ifndef OPENR_COMPAT_HEAP_H_INCLUDED
#define OPENR_COMPAT_HEAP_H_INCLUDED

#include <algorithm>

using std::make_heap;
using std::pop_heap;
using std::push_heap;
using std::sort_heap;

#endif  // OPENR_COMPAT_HEAP_H_INCLUDED
