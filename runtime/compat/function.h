// The header <function.h> of old C++: the names of <functional> without std::.
#ifndef OPENR_COMPAT_FUNCTION_H_INCLUDED
#define OPENR_COMPAT_FUNCTION_H_INCLUDED

#include <functional>

using std::binary_function;
using std::binary_negate;
using std::bind1st;
using std::bind2nd;
using std::binder1st;
using std::binder2nd;
using std::divides;
using std::equal_to;
using std::greater;
using std::greater_equal;
using std::less;
using std::less_equal;
using std::logical_and;
using std::logical_not;
using std::logical_or;
using std::mem_fun;
using std::mem_fun_ref;
using std::minus;
using std::modulus;
using std::multiplies;
using std::negate;
using std::not1;
using std::not2;
using std::not_equal_to;
using std::plus;
using std::ptr_fun;
using std::unary_function;
using std::unary_negate;

#endif  // OPENR_COMPAT_FUNCTION_H_INCLUDED
