// Limits of an object, for GetResourceValue() and SetResourceValue() (MCOOP.h).
#ifndef OPENR_SYSTEMRESOURCE_H_INCLUDED
#define OPENR_SYSTEMRESOURCE_H_INCLUDED

#include <Types.h>

typedef longword sResource;

const sResource rUNDEF = 0;
const sResource SystemCommonResourceBase = 0;
const sResource SystemResourceBase = 10;

const sResource rMAXMESSAGESIZE = 10;  // bytes of one message
const sResource rMAXQUEUESIZE = 11;    // waiting messages; 32 unless changed
const sResource rMAXEVENT = 12;        // events that are not cancelled
const sResource rMAXENTRIES = 13;      // selectors; always 64
const sResource rMAXSWITCHNUMOFS = 14;

// The number of values reserved for limits.
const sResource NumberOfResource = 270;

#endif  // OPENR_SYSTEMRESOURCE_H_INCLUDED
