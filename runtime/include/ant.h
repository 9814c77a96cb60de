// The header that every program for the network includes first.
#ifndef OPENR_ANT_H_INCLUDED
#define OPENR_ANT_H_INCLUDED

#include <OPENR/CLibrary.h>
#include <antEnvMsg.h>
#include <antModuleRef.h>
#include <antSharedBuffer.h>
#include <antTypes.h>

#endif  // OPENR_ANT_H_INCLUDED
