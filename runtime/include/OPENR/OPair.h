// A pair of values of any two types.
#ifndef OPENR_OPAIR_H_INCLUDED
#define OPENR_OPAIR_H_INCLUDED

template <class T1, class T2>
struct OPair {
  T1 first;
  T2 second;

  OPair() : first(), second() {}
  OPair(const T1& a, const T2& b) : first(a), second(b) {}
};

#endif  // OPENR_OPAIR_H_INCLUDED
