// The status that functions of OList, OQueue, ODeque and ArrayStack return.
#ifndef OPENR_OTLSTATUS_H_INCLUDED
#define OPENR_OTLSTATUS_H_INCLUDED

typedef int OTLStatus;
const OTLStatus otlSUCCESS = 0;
const OTLStatus otlOVERFLOW = 1;   // the container is full: nothing was added
const OTLStatus otlUNDERFLOW = 2;  // the container is empty: nothing was removed
const OTLStatus otlFAIL = 3;
const OTLStatus otlNOMEMORY = 4;

#endif  // OPENR_OTLSTATUS_H_INCLUDED
