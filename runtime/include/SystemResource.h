// Limits of an object that GetResourceValue() and SetResourceValue() (MCOOP.h) know.
#ifndef OPENR_SYSTEMRESOURCE_H_INCLUDED
#define OPENR_SYSTEMRESOURCE_H_INCLUDED

#include <Types.h>

typedef longword sResource;

const sResource rMAXMESSAGESIZE = 10;  // bytes of one message
const sResource rMAXQUEUESIZE = 11;    // waiting messages, 32 unless changed
const sResource rMAXEVENT = 12;        // timed messages alive
const sResource rMAXENTRIES = 13;      // selectors, 64

#endif  // OPENR_SYSTEMRESOURCE_H_INCLUDED
