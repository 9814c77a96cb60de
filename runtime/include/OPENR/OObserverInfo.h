// OObserverInfo: identifies one of the observers with which a subject is connected.
#ifndef OPENR_OOBSERVERINFO_H_INCLUDED
#define OPENR_OOBSERVERINFO_H_INCLUDED

#include <OPENR/ObjcommTypes.h>

class RCRegion;
typedef RCRegion* RCRegion_p;

class OObserverInfo {
 public:
  OObserverInfo() {}
  explicit OObserverInfo(const ObserverID& id) : id_(id) {}

  const ObserverID& GetObserverID() const { return id_; }

 private:
  ObserverID id_;
};

typedef OObserverInfo ObserverInfo;
typedef std::list<OObserverInfo>::const_iterator ObserverConstIterator;

#endif  // OPENR_OOBSERVERINFO_H_INCLUDED
