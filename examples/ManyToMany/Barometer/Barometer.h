//
// Barometer sends three readings to all connected observers.
//
//   Barometer.Value -> Display.Value, Recorder.Value
//

#ifndef Barometer_h_DEFINED
#define Barometer_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>

#include "def.h"

class Barometer : public OObject {
public:
    Barometer() : numSent_(0) {}
    virtual ~Barometer() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadyValue(const OReadyEvent& event);

private:
    int numSent_;
};

#endif  // Barometer_h_DEFINED
