//
// The part of RCServer that does not use OPEN-R: makes the answer to a request
// (docs/remote-control.md).
//
// All clients share the robot: when one client sets a limit of speed or acceleration, the limit is
// valid for all, and the last command counts.  The handler has no state of single connections.
//

#ifndef RequestHandler_h_DEFINED
#define RequestHandler_h_DEFINED

#include "MtnFile.h"
#include "RemoteProtocol.h"
#include "RequestPort.h"
#include "SensorValues.h"

class RequestHandler {
public:
    // Makes a handler.  `port` must outlive the handler.
    explicit RequestHandler(RequestPort* port);

    void Begin(const RobotConstants* robot);

    // Set the newest sensor values of the robot, and the newest report of JointMover.
    void SetSensors(const SensorValues& values) { sensors_ = values; }
    void SetMover(const SetValueMessage& message);
    // Called when JointMover accepts commands.
    void MoverIsReady();

    // Writes to `out` the answer to the packet in `request`.  REQUIRES: `out` is empty and has room
    // for RC_MAX_PACKET bytes.
    void Answer(const RcFramer& request, RcWriter* out);

    // Writes to `out` the answer to bytes that are no packet; `error` is the reason.  The
    // connection ends after this answer.
    void AnswerBroken(const std::string& error, RcWriter* out);

    // Writes to `out` the answer that all `places` are taken by clients that have sent requests in
    // the last `seconds`.  The connection ends after this answer.  `request` is 0 when the client
    // has sent none.
    void AnswerNoPlace(const RcFramer* request, int places, int seconds, RcWriter* out);

private:
    void BeginAnswer(RcWriter* out, int status);
    int Handle(int command, RcReader* in, RcWriter* out);
    int Describe(RcReader* in, RcWriter* out);
    int GetJoint(RcReader* in, RcWriter* out);
    int CommandJoint(int command, RcReader* in, RcWriter* out);
    int CommandLight(int command, RcReader* in, RcWriter* out);
    int TellSensors(RcReader* in, RcWriter* out);
    int TellInfo(RcReader* in, RcWriter* out);
    int PlayMotion(RcReader* in, RcWriter* out);
    int StopMotion(RcReader* in);
    int LoadMotion(const std::string& file, MoverCommand* command, RcPlayAnswer* answer);
    int Busy(bool duringMotion);
    int Post(const MoverCommand& command);
    int Fail(int status, const std::string& why);
    int FailSize();
    int FailIndex(const char* what, int index, int count);
    bool DescribeDevice(int kind, int index, RcDescription* description) const;
    int NumDevices(int kind) const;
    const SensorConstants* FindInGroup(SensorGroup group, int index) const;

    RequestPort* port_;
    const RobotConstants* robot_;
    SensorValues sensors_;
    int state_;  // MoverState in the newest report of JointMover; -1: no report yet
    Sint32 keyFrame_;
    Sint32 speed_[MAX_JOINTS];  // limits last set by remote control (Hohl 2004, 5.3.6)
    Sint32 acceleration_[MAX_JOINTS];
    std::string error_;  // error text of the present request
    MtnFile motion_;     // motion file to check; not a local variable, because its parts are large
};

#endif  // RequestHandler_h_DEFINED
