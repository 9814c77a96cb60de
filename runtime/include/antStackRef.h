// A reference to a network stack, found by its name: antStackRef ref("IPStack").
#ifndef OPENR_ANTSTACKREF_H_INCLUDED
#define OPENR_ANTSTACKREF_H_INCLUDED

#include <antTypes.h>

struct MAV_Dispatcher;  // a type of the system, which programs cannot use

class antStackRef {
 public:
  antStackRef() : dispatcher_(0) {}
  antStackRef(const OID& oid) : oid_(oid), dispatcher_(0) {}

  // Finds the network stack by its name; the reference is invalid if no object has that name.
  antStackRef(const char* name);

  bool IsValid() const { return oid_.IsValid(); }
  OID get_oid() const { return oid_; }
  MAV_Dispatcher* get_disp() const { return dispatcher_; }  // returns 0 on the host

 private:
  OID oid_;
  MAV_Dispatcher* dispatcher_;
};

#endif  // OPENR_ANTSTACKREF_H_INCLUDED
