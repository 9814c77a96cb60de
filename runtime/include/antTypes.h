// Basic types of the network stack (ANT is the name of its family of components).
#ifndef OPENR_ANTTYPES_H_INCLUDED
#define OPENR_ANTTYPES_H_INCLUDED

#include <OID.h>
#include <Types.h>  // byte, int16, uint16, int32, uint32, TRUE, FALSE
#include <antErrors.h>

typedef int boolean;
typedef OID antObjectID;

#endif  // OPENR_ANTTYPES_H_INCLUDED
