// The header that programs include for shared buffers.
#ifndef OPENR_ANTSHAREDBUFFER_H_INCLUDED
#define OPENR_ANTSHAREDBUFFER_H_INCLUDED

#include <antSharedBufferDef.h>

#endif  // OPENR_ANTSHAREDBUFFER_H_INCLUDED
