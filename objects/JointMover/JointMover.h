//
// JointMover moves the joints: it brings the robot to its standing posture after the start, carries
// out commands for single joints, and plays motion files.
//
//   JointMover.Move           -> OVirtualRobotComm.Effector
//   JointMover.Mover          <- commands of RCServer and Controller
//   JointMover.BatchMover     <- the joint buffer of Controller
//   JointMover.SetValue       -> state, key frame and positions, to RCServer and Controller
//   JointMover.MainExecution  -> tells Controller that the robot stands
//
// Mover and BatchMover become ready only when the robot stands, so that their senders can see when
// commands are accepted.  MoverCore decides what to do; this class connects MoverCore with OPEN-R.
//

#ifndef JointMover_h_DEFINED
#define JointMover_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <OPENR/ODataFormats.h>

#include "MoverCore.h"
#include "def.h"

class JointMover : public OObject, private MoverPort {
public:
    JointMover();
    virtual ~JointMover() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadyMove(const OReadyEvent& event);
    void ReadyMainExecution(const OReadyEvent& event);
    void NotifyMover(const ONotifyEvent& event);
    void NotifyBatchMover(const ONotifyEvent& event);

private:
    // Number of regions for command vectors: one vector plays while the other waits.
    static const int NUM_REGIONS = MAX_VECTORS_UNDER_WAY;

    // The functions of MoverPort, which MoverCore calls.
    virtual Sint32 Measure(int joint);
    virtual void EnableGain(int joint, const Sint32 gain[3]);
    virtual void DisableGain(int joint);
    virtual void SetMotorPower(bool on);
    virtual void StateChanged(MoverState state);
    virtual void Report(const SetValueMessage& message);
    virtual void InitialPostureReached();

    OStatus OpenJoints();
    OStatus NewRegions();
    int NumBusyRegions() const;
    RCRegion* FindFreeRegion();
    void FillRegion(RCRegion* region);
    void SendVectors();
    void SendReports();
    void TellMainExecution();
    void Play(const MoverCommand& command);

    const RobotConstants* robot_;
    OPrimitiveID joint_[MAX_JOINTS];
    RCRegion* region_[NUM_REGIONS];
    int numUnderWay_;  // number of sent vectors for which VectorEnded() was not called yet
    int numReports_;   // number of messages that were set on the subject SetValue and not sent yet
    bool isStopped_;  // true until DoInit has succeeded, and again from DoStop on
    bool isUp_;  // whether the robot has reached its initial posture
    MoverCore core_;
    VectorPlan nextVector_;  // 1300 bytes; a member, because the stack of an object is small
};

#endif  // JointMover_h_DEFINED
