// The header <deque.h> of old C++: the names of <deque> without std::.
#ifndef OPENR_COMPAT_DEQUE_H_INCLUDED
#define OPENR_COMPAT_DEQUE_H_INCLUDED

#include <deque>

using std::deque;

#endif  // OPENR_COMPAT_DEQUE_H_INCLUDED
