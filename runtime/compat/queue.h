// The header <queue.h> of old C++: the names of <queue> without std::.
#ifndef OPENR_COMPAT_QUEUE_H_INCLUDED
#define OPENR_COMPAT_QUEUE_H_INCLUDED

#include <queue>

using std::priority_queue;
using std::queue;

#endif  // OPENR_COMPAT_QUEUE_H_INCLUDED
