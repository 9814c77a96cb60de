// Messages and names of a constructor.
#ifndef Early_h_DEFINED
#define Early_h_DEFINED

#include <MCOOP.h>
#include <OPENR/OPENR.h>

#include <string>

const Selector earlyEntry = 11;  // DoEarly, the last entry of stub.cfg

// If the stick has the file OWN.TXT: sends a message to the entry DoEarly of `own`, the object that
// runs, and a request to the object talker, and registers the name "early bird" for `own`.  Returns
// whether the file is there.
bool SendEarly(OID own);

// The results of the calls of SendEarly(), and the reply to its request.
std::string AnswerEarly();

#endif  // Early_h_DEFINED
