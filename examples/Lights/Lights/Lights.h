//
// Lights switches the six eye lights on one after the other, for three rounds, then all together.
//
//   Lights.Led -> OVirtualRobotComm.Effector
//
// LEDs need no motor power and no gains.
//

#ifndef Lights_h_DEFINED
#define Lights_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <OPENR/ODataFormats.h>

#include "def.h"

class Lights : public OObject {
public:
    Lights();
    virtual ~Lights() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadyLed(const OReadyEvent& event);

private:
    static const int NUM_LEDS = 6;
    static const int NUM_ROUNDS = 3;
    static const int PERIOD = 16;  // time for which each light is on, in frames of 8 ms

    OStatus OpenLeds();
    RCRegion* NewRegion();
    void FillRound(OCommandVectorData* vector);
    void FillAllOn(OCommandVectorData* vector);

    OPrimitiveID led_[NUM_LEDS];
    RCRegion* round_;  // a vector that never changes can be sent again and again
    RCRegion* allOn_;
    int numSent_;  // number of rounds sent
};

#endif  // Lights_h_DEFINED
