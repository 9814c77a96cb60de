//
// StandUp moves the legs: the dog stands up, crouches, stands again.
//
//   StandUp.Move -> OVirtualRobotComm.Effector
//
// A servo goes to each set point as fast as it can.  So this object sends a set point for every
// frame of 8 ms, 16 in a vector.  It keeps two vectors in the Effector: while one plays, the other
// waits.
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

    // The state is DONE until DoInit has succeeded, because readies come even when DoInit has
    // failed.
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
    double from_[NUM_LEG_JOINTS];  // angles in degrees at which the present movement begins
    int posture_;                  // index of the posture to which the dog moves
    int vector_;                   // number of the next vector of this movement
};

#endif  // StandUp_h_DEFINED
