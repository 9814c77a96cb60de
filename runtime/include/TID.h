// The name of a transaction: an object that waits, and which of its reply boxes is meant.
#ifndef OPENR_TID_H_INCLUDED
#define OPENR_TID_H_INCLUDED

#include <OID.h>
#include <Types.h>

// A TID as plain data, for structures that C reads as well.
struct BaseTID {
  structOID mailer;
  longword value;
};

class TID : public BaseTID {
 public:
  TID() { MakeInvalid(); }
  TID(const OID& object, longword number) {
    mailer = object;
    value = number;
  }

  // True iff the mailer is a valid object.
  bool IsValid() const { return GetMailer().IsValid(); }
  void MakeInvalid() {
    mailer = OID();
    value = UNDEF;
  }

  // The object that waits for the answer, and which of its boxes is meant.
  OID GetMailer() const { return OID(mailer.address); }
  longword GetValue() const { return value; }

  bool operator==(const TID& other) const {
    return GetMailer() == other.GetMailer() && value == other.value;
  }
  bool operator!=(const TID& other) const { return !(*this == other); }
};

#endif  // OPENR_TID_H_INCLUDED
