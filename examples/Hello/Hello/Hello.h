//
// Hello prints a line at each of the four events in the life of every object.
//

#ifndef Hello_h_DEFINED
#define Hello_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>

#include "def.h"

class Hello : public OObject {
public:
    Hello();
    virtual ~Hello() {}

    // Arrays that the stub uses by name.  stubgen2 makes the stub from stub.cfg.
    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);
};

#endif  // Hello_h_DEFINED
