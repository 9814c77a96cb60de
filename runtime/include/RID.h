// The name of a reply box: where the answer to a SendWithRBox() will arrive.
#ifndef OPENR_RID_H_INCLUDED
#define OPENR_RID_H_INCLUDED

#include <TID.h>

typedef TID RID;

#endif  // OPENR_RID_H_INCLUDED
