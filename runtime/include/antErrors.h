// Errors of the network stack about a message as a whole.  The result of the requested operation is
// in the `error` field of the message, as an error number of the message's protocol.
#ifndef OPENR_ANTERRORS_H_INCLUDED
#define OPENR_ANTERRORS_H_INCLUDED

#include <iostream>

enum antError {
  ANT_SUCCESS = 0,
  ANT_FAIL = 1,
  ANT_NOMEMORY = 2,
  ANT_INVALIDPTR = 3,
  ANT_NO_STATE_TRANSITION = 4,
  ANT_SDU_BADRANGE = 5,
  ANT_SDU_NOMORE_DATACELL = 6,
  ANT_SDU_NOOWNER = 7,
  ANT_SDUPOOL_ALLOCATED = 8,
  ANT_SDUPOOL_NOTASSIGNED = 9,
  ANT_QUEUE_EMPTY = 10,
  ANT_QUEUE_STATE = 11,
  ANT_QUEUE_CLOSED = 12,
  ANT_QUEUE_REJECTED = 13,
  ANT_QUEUE_BLOCKED = 14,
  ANT_INVALIDMODULEID = 15,
  ANT_TMR_TYPE_INVALID = 16,
  ANT_TMR_MAXNMBR_REACHED = 17,
  ANT_NOMESSAGES = 18,
  ANT_NAMING_ENTRY_EXISTS = 19,
  ANT_NAMING_NO_SUCH_NAME = 20,
  ANT_NAMING_NAME_INVALID = 21,
  ANT_REGISTRY_DUPLICATE_KEY = 22,
  ANT_REGISTRY_NO_KEY = 23,
  ANT_REGISTRY_WRONG_TYPE = 24,
  ANT_REGISTRY_INVALID_KEY = 25,
  ANT_REGISTRY_INVALID_VALUE = 26,
  ANT_ENDPOINT_NOFACTORY = 27,
  ANT_NOT_INITIALIZED = 28,
  ANT_INITIALIZING = 29
};

// A notification of the network stack, not an error; the host does not use it.
const int ANT_SDUMEMORY_AVAILABLE = 1;

// Returns the name of the error's constant, such as "ANT_FAIL".  Returns "unknown antError" for a
// number that belongs to no constant.
const char* antErrorString(antError error);

// Writes the name of the error's constant, such as "ANT_FAIL".
std::ostream& operator<<(std::ostream& out, antError error);

#endif  // OPENR_ANTERRORS_H_INCLUDED
