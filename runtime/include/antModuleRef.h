// The handle of an endpoint, opaque to programs.
#ifndef OPENR_ANTMODULEREF_H_INCLUDED
#define OPENR_ANTMODULEREF_H_INCLUDED

#include <antTypes.h>

#include <iostream>

// 8 bytes on the robot.  The stack fills in the fields; it never gives the same pair to
// two endpoints.  A null reference names the stack itself.
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

  // "module 3" on the console: the index alone, since the pointer differs between runs.
  void Print() const;
};

std::ostream& operator<<(std::ostream& out, const antModuleRef& ref);

#endif  // OPENR_ANTMODULEREF_H_INCLUDED
