// Includes the base class of all messages to the network stack, and the messages to the stack
// itself.
#ifndef OPENR_ANTENVMSG_H_INCLUDED
#define OPENR_ANTENVMSG_H_INCLUDED

#include <antEnvBaseMsg.h>
#include <antEnvInternalMsg.h>

#endif  // OPENR_ANTENVMSG_H_INCLUDED
