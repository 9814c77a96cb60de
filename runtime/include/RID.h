// The name of a reply box: where the answer to a SendWithRBox() will arrive.
#ifndef OPENR_RID_H_INCLUDED
#define OPENR_RID_H_INCLUDED

#include <OID.h>
#include <Types.h>

class TID {
 public:
  TID() : value_(UNDEF) {}
  TID(const OID& mailer, longword value) : mailer_(mailer), value_(value) {}

  // True iff the mailer is a valid object.
  bool IsValid() const { return mailer_.IsValid(); }
  void MakeInvalid() {
    mailer_.MakeInvalid();
    value_ = UNDEF;
  }

  // The object that waits for the answer, and which of its boxes is meant.
  OID GetMailer() const { return mailer_; }
  longword GetValue() const { return value_; }

  bool operator==(const TID& other) const {
    return mailer_ == other.mailer_ && value_ == other.value_;
  }
  bool operator!=(const TID& other) const { return !(*this == other); }

 private:
  OID mailer_;
  longword value_;
};

typedef TID RID;

#endif  // OPENR_RID_H_INCLUDED
