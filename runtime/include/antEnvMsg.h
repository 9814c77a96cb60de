// Messages to the network stack: the base and the stack's own.
#ifndef OPENR_ANTENVMSG_H_INCLUDED
#define OPENR_ANTENVMSG_H_INCLUDED

#include <antEnvBaseMsg.h>
#include <antEnvInternalMsg.h>

#endif  // OPENR_ANTENVMSG_H_INCLUDED
