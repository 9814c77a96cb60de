//
// Ears flicks the left and the right ear in turn, three times each.
//
//   Ears.Ear -> OVirtualRobotComm.Effector
//
// An ear is moved by a plunger, an actuator with two positions and no sensor.
//

#ifndef Ears_h_DEFINED
#define Ears_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <OPENR/ODataFormats.h>

#include "def.h"

class Ears : public OObject {
public:
    Ears();
    virtual ~Ears() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadyEar(const OReadyEvent& event);

private:
    static const int NUM_EARS = 2;
    static const int NUM_FLICKS = 6;

    OStatus OpenEars();
    OStatus NewRegion();
    void Flick(int ear);
    void Rest();

    OPrimitiveID ear_[NUM_EARS];
    RCRegion* region_;
    int numSent_;
};

#endif  // Ears_h_DEFINED
