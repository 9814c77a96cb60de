// OObserverVector, the old name of the class OObserver.
#ifndef OPENR_OOBSERVERVECTOR_H_INCLUDED
#define OPENR_OOBSERVERVECTOR_H_INCLUDED

#include <OPENR/OObserver.h>

typedef OObserver OObserverVector;

#endif  // OPENR_OOBSERVERVECTOR_H_INCLUDED
