// The old name of OObserverInfo.h.
#ifndef OPENR_OBSERVERINFO_H_INCLUDED
#define OPENR_OBSERVERINFO_H_INCLUDED

#warning "ObserverInfo.h is the old name: include OPENR/OObserverInfo.h"
#include <OPENR/OObserverInfo.h>

#endif  // OPENR_OBSERVERINFO_H_INCLUDED
