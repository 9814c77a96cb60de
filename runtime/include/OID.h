// The identity of an object, which the system assigns when it loads the object.
//
// On the robot an OID is an address such as 0x80000042.  Programs only compare OIDs, print them and
// pass them on.
#ifndef OPENR_OID_H_INCLUDED
#define OPENR_OID_H_INCLUDED

#include <Types.h>

// OID_UNDEF is the value of a default constructed OID; the other constant is the OID that means
// every object.
void* const OID_UNDEF = reinterpret_cast<void*>(0xffffffffUL);
void* const OID_ALL = 0;

// An OID (the id of an object) as plain data, for structures that C code reads too.
struct structOID {
  void* address;
};

class OID : public structOID {
 public:
  OID() { address = OID_UNDEF; }
  OID(void* place) { address = place; }

  void SetAddress(void* place) { address = place; }
  void* GetAddress() const { return address; }

  bool IsValid() const { return address != OID_UNDEF; }
  void MakeInvalid() { address = OID_UNDEF; }

  bool operator==(const OID& other) const { return address == other.address; }
  bool operator!=(const OID& other) const { return address != other.address; }
  bool operator<(const OID& other) const { return Number() < other.Number(); }
  bool operator<=(const OID& other) const { return Number() <= other.Number(); }
  bool operator>(const OID& other) const { return Number() > other.Number(); }
  bool operator>=(const OID& other) const { return Number() >= other.Number(); }

 private:
  // Returns the address of this OID as a number for comparing, because comparing unrelated pointers
  // is undefined in C++.
  size_t Number() const { return reinterpret_cast<size_t>(address); }
};

#endif  // OPENR_OID_H_INCLUDED
