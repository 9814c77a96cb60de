// An object that does in DoStart what the file TROUBLE.TXT of its stick says.
#ifndef Trouble_h_DEFINED
#define Trouble_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

class Trouble : public OObject {
public:
    Trouble() {}
    virtual ~Trouble() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);
};

#endif  // Trouble_h_DEFINED
