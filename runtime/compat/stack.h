// The header <stack.h> of old C++: the names of <stack> without std::.
#ifndef OPENR_COMPAT_STACK_H_INCLUDED
#define OPENR_COMPAT_STACK_H_INCLUDED

#include <stack>

using std::stack;

#endif  // OPENR_COMPAT_STACK_H_INCLUDED
