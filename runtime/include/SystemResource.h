// Limits of an object, for GetResourceValue() and SetResourceValue() (MCOOP.h).
#ifndef OPENR_SYSTEMRESOURCE_H_INCLUDED
#define OPENR_SYSTEMRESOURCE_H_INCLUDED

#include <Types.h>

typedef longword sResource;

const sResource rUNDEF = 0;
const sResource SystemCommonResourceBase = 0;
const sResource SystemResourceBase = 10;

const sResource rMAXMESSAGESIZE = 10;  // the limit for the size of a message, in bytes
const sResource rMAXQUEUESIZE = 11;    // limit for the messages that wait; 32 unless changed
const sResource rMAXEVENT = 12;        // limit for events that were requested and are pending
const sResource rMAXENTRIES = 13;      // limit for the number of entries; always 64
const sResource rMAXSWITCHNUMOFS = 14;

// The number of values of sResource that are reserved for limits of an object.
const sResource NumberOfResource = 270;

#endif  // OPENR_SYSTEMRESOURCE_H_INCLUDED
