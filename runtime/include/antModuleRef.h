// antModuleRef, the reference to an endpoint of the network stack.  Its fields mean nothing to
// programs.
#ifndef OPENR_ANTMODULEREF_H_INCLUDED
#define OPENR_ANTMODULEREF_H_INCLUDED

#include <antTypes.h>

#include <iostream>

// The reference to an endpoint, 8 bytes on the robot.  The network stack sets its fields, to
// different values for each endpoint.  A null reference means the stack itself.
class antModuleRef {
 public:
  void* module;
  uint32 index;

  antModuleRef() : module(0), index(0) {}

  bool IsNull() const { return module == 0 && index == 0; }
  bool operator==(const antModuleRef& other) const {
    return module == other.module && index == other.index;
  }
  bool operator!=(const antModuleRef& other) const { return !(*this == other); }

  // Prints a line such as "module 3" on the console.  The number is `index`; the pointer `module`
  // is not printed.
  void Print() const;
};

std::ostream& operator<<(std::ostream& out, const antModuleRef& ref);

#endif  // OPENR_ANTMODULEREF_H_INCLUDED
