//
// Talker sends three lines, each when its listener is ready for it.
//
//   Talker.Say -> Listener.Hear
//

#ifndef Talker_h_DEFINED
#define Talker_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>

#include "def.h"

class Talker : public OObject {
public:
    Talker() : numSaid_(0) {}
    virtual ~Talker() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadySay(const OReadyEvent& event);

private:
    void Say(const char* text);

    int numSaid_;
};

#endif  // Talker_h_DEFINED
