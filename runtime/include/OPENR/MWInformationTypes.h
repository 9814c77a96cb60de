// Identifiers of the "level 1" information service of OPEN-R, for which there is no document.
#ifndef OPENR_MWINFORMATIONTYPES_H_INCLUDED
#define OPENR_MWINFORMATIONTYPES_H_INCLUDED

#include <Types.h>

typedef longword MWIID;
const MWIID mwiidINVALID = 0xffffffff;

// Types for parts that can be attached to the robot, and for their sensors.  No document that we
// know gives their values.
typedef byte AttachedParts;
typedef byte AttachedPosition;
typedef byte SensorType;

#endif  // OPENR_MWINFORMATIONTYPES_H_INCLUDED
