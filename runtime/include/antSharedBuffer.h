// The name under which programs include the shared buffer.
#ifndef OPENR_ANTSHAREDBUFFER_H_INCLUDED
#define OPENR_ANTSHAREDBUFFER_H_INCLUDED

#include <antSharedBufferDef.h>

#endif  // OPENR_ANTSHAREDBUFFER_H_INCLUDED
