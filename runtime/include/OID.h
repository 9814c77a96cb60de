// The identity of an object, given by the system when the object is loaded.
//
// It is an address on the robot, a number that looks like 0x80000042, and only ever
// compared, printed and passed on.
#ifndef OPENR_OID_H_INCLUDED
#define OPENR_OID_H_INCLUDED

#include <Types.h>

// What a default constructed OID holds, and the OID that stands for every object.
void* const OID_UNDEF = reinterpret_cast<void*>(0xffffffffUL);
void* const OID_ALL = 0;

// The same as plain data, for structures that C reads as well.
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
  // Ids are ordered as numbers; comparing unrelated pointers has no defined result.
  size_t Number() const { return reinterpret_cast<size_t>(address); }
};

#endif  // OPENR_OID_H_INCLUDED
