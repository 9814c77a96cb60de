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

class OID {
 public:
  OID() : address_(OID_UNDEF) {}
  OID(void* address) : address_(address) {}

  void SetAddress(void* address) { address_ = address; }
  void* GetAddress() const { return address_; }

  bool IsValid() const { return address_ != OID_UNDEF; }
  void MakeInvalid() { address_ = OID_UNDEF; }

  bool operator==(const OID& other) const { return address_ == other.address_; }
  bool operator!=(const OID& other) const { return address_ != other.address_; }
  bool operator<(const OID& other) const { return Number() < other.Number(); }
  bool operator<=(const OID& other) const { return Number() <= other.Number(); }
  bool operator>(const OID& other) const { return Number() > other.Number(); }
  bool operator>=(const OID& other) const { return Number() >= other.Number(); }

 private:
  // Ids are ordered as numbers; comparing unrelated pointers has no defined result.
  size_t Number() const { return reinterpret_cast<size_t>(address_); }

  void* address_;
};

#endif  // OPENR_OID_H_INCLUDED
