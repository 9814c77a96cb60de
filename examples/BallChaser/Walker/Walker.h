//
// Walker moves the dog: it walks as Chaser tells it, holds the head, and gets up after a fall.
//
//   Walker.Move -> OVirtualRobotComm.Effector
//   Walker.Sensor <- OVirtualRobotComm.Sensor
//   Walker.Command <- Chaser.Walk
//
// Motion computes the angles; this object takes them to the joints.  It keeps two vectors of four
// frames in the Effector: while one plays, the other waits.  So a new command is heard within 64
// ms.
//

#ifndef Walker_h_DEFINED
#define Walker_h_DEFINED

#include <OPENR/ODataFormats.h>
#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "Motion.h"
#include "def.h"

class Walker : public OObject {
public:
    Walker();
    virtual ~Walker() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadyMove(const OReadyEvent& event);
    void NotifySensor(const ONotifyEvent& event);
    void NotifyCommand(const ONotifyEvent& event);

private:
    static const int NUM_REGIONS = 2;
    static const int NUM_FRAMES = 4;
    static const int NUM_AXES = 3;

    // The state is OFF until DoInit has succeeded, because readies come even when DoInit has
    // failed.
    enum State { OFF, IDLE, HOLDING, MOVING };

    OStatus OpenPrimitives();
    OStatus NewRegions();
    RCRegion* FindFreeRegion();
    void HoldStill();
    void EnableGains();
    void SendVectors();
    void FillVector(OCommandVectorData* vector);
    void FindAxes(OSensorFrameVectorData* vector);

    State state_;
    Motion motion_;
    OPrimitiveID joint_[NUM_JOINTS];
    OPrimitiveID axis_[NUM_AXES];  // acceleration sensors: to the front, to the right, up
    int axisElement_[NUM_AXES];    // their elements in sensor vectors; -1 before the first vector
    RCRegion* region_[NUM_REGIONS];
};

#endif  // Walker_h_DEFINED
