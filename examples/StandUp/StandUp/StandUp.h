//
// StandUp moves the legs: the dog stands up, crouches, stands again.
//
//   StandUp.Move -> OVirtualRobotComm.Effector
//
// A servo tries to reach each set point at once, so we send one for every frame of 8 ms, 16
// in a vector, and keep two vectors under way: while one plays, the other waits behind it.
//

#ifndef StandUp_h_DEFINED
#define StandUp_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <OPENR/ODataFormats.h>

#include "LegTable.h"
#include "def.h"

class StandUp : public OObject {
public:
    StandUp();
    virtual ~StandUp() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadyMove(const OReadyEvent& event);

private:
    static const int NUM_REGIONS = 2;
    static const int NUM_FRAMES = ocommandMAX_FRAMES;

    // DONE until DoInit has succeeded: readies come even when it has failed.
    enum State { IDLE, HOLDING, MOVING, DONE };

    OStatus OpenJoints();
    OStatus NewRegions();
    RCRegion* FindFreeRegion();
    void HoldStill();
    void EnableGains();
    void SendVectors();
    void FillNextVector(OCommandVectorData* vector);
    void BeginPosture();

    State state_;
    OPrimitiveID joint_[NUM_LEG_JOINTS];
    RCRegion* region_[NUM_REGIONS];
    double from_[NUM_LEG_JOINTS];  // degrees, where the present way begins
    int posture_;                  // that we are on the way to
    int vector_;                   // next one of that way
};

#endif  // StandUp_h_DEFINED
