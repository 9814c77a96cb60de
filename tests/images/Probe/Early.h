// Messages and names of a constructor.
#ifndef Early_h_DEFINED
#define Early_h_DEFINED

#include <MCOOP.h>
#include <OPENR/OPENR.h>

#include <string>

const Selector earlyEntry = 11;  // DoEarly, the last entry of stub.cfg

// If the stick has the file OWN.TXT: sends a message to the entry DoEarly of `own`, the object that
// runs, and a request to the object talker, and registers the name "early bird" for `own`.  If the
// stick has the file ASK.TXT, too, also sends a request to DoEarly, which does not reply.  Returns
// whether the file OWN.TXT is there.
bool SendEarly(OID own);

// If SendEarly() has sent a request to DoEarly, sends two more, so that three reply boxes are open.
void AskAgain(OID own);

// The results of the calls of SendEarly(), and the reply to its request.
std::string AnswerEarly();

#endif  // Early_h_DEFINED
