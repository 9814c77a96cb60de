// DataInfo: one region that an observer has received, with the subject that sent it.
#ifndef OPENR_DATAMANAGER_H_INCLUDED
#define OPENR_DATAMANAGER_H_INCLUDED

#include <OPENR/OPENR.h>
#include <OPENR/RCRegion.h>

struct DataInfo {
  OServiceEntry subject;  // the subject that has sent the region
  RCRegion* myRCRegion;   // the observer's own RCRegion for the memory of the region
  RCRegion* srcRCRegion;  // the subject's RCRegion, given back with the next ready
};

#endif  // OPENR_DATAMANAGER_H_INCLUDED
