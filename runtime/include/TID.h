// TID, the id of a transaction.  A TID has the object that waits for an answer, and the number of
// the reply box in which the object receives the answer.
#ifndef OPENR_TID_H_INCLUDED
#define OPENR_TID_H_INCLUDED

#include <OID.h>
#include <Types.h>

// A TID (the id of a transaction) as plain data, for structures that C code reads too.
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

  // Returns whether the mailer, the object that waits for the answer, is a valid object.
  bool IsValid() const { return GetMailer().IsValid(); }
  void MakeInvalid() {
    mailer = OID();
    value = UNDEF;
  }

  // Return the object that waits for the answer, and the number of its reply box.
  OID GetMailer() const { return OID(mailer.address); }
  longword GetValue() const { return value; }

  bool operator==(const TID& other) const {
    return GetMailer() == other.GetMailer() && value == other.value;
  }
  bool operator!=(const TID& other) const { return !(*this == other); }
};

#endif  // OPENR_TID_H_INCLUDED
