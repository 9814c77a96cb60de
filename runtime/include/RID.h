// The id of a reply box, in which the answer to a SendWithRBox() arrives.
#ifndef OPENR_RID_H_INCLUDED
#define OPENR_RID_H_INCLUDED

#include <TID.h>

typedef TID RID;

#endif  // OPENR_RID_H_INCLUDED
