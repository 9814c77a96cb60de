//
// Thermometer sends three readings to all connected observers.
//
//   Thermometer.Value -> Display.Value, Recorder.Value
//

#ifndef Thermometer_h_DEFINED
#define Thermometer_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>

#include "def.h"

class Thermometer : public OObject {
public:
    Thermometer() : numSent_(0) {}
    virtual ~Thermometer() {}

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

#endif  // Thermometer_h_DEFINED
