// Identifiers of the undocumented "level 1" information service.
#ifndef OPENR_MWINFORMATIONTYPES_H_INCLUDED
#define OPENR_MWINFORMATIONTYPES_H_INCLUDED

#include <Types.h>

typedef longword MWIID;
const MWIID mwiidINVALID = 0xffffffff;

#endif  // OPENR_MWINFORMATIONTYPES_H_INCLUDED
