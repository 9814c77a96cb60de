// The header <iterator.h> of old C++: the names of <iterator> without std::.
#ifndef OPENR_COMPAT_ITERATOR_H_INCLUDED
#define OPENR_COMPAT_ITERATOR_H_INCLUDED

#include <iterator>

using std::advance;
using std::back_insert_iterator;
using std::back_inserter;
using std::bidirectional_iterator_tag;
using std::distance;
using std::forward_iterator_tag;
using std::front_insert_iterator;
using std::front_inserter;
using std::input_iterator_tag;
using std::insert_iterator;
using std::inserter;
using std::istream_iterator;
using std::iterator;
using std::ostream_iterator;
using std::output_iterator_tag;
using std::random_access_iterator_tag;
using std::reverse_iterator;

#endif  // OPENR_COMPAT_ITERATOR_H_INCLUDED
