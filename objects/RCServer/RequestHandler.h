//
// RCServer without OPEN-R: one request in, one answer out (docs/remote-control.md).
//
// Clients share one robot: limits of speed and acceleration that one sets hold for all, and the
// last command counts.  A handler keeps no state of a connection.
//

#ifndef RequestHandler_h_DEFINED
#define RequestHandler_h_DEFINED

#include "MtnFile.h"
#include "RemoteProtocol.h"
#include "RequestPort.h"
#include "SensorValues.h"

class RequestHandler {
public:
    // `port` must outlive the handler.
    explicit RequestHandler(RequestPort* port);

    void Begin(const RobotConstants* robot);

    // The newest news of the robot.
    void SetSensors(const SensorValues& values) { sensors_ = values; }
    void SetMover(const SetValueMessage& message);
    // JointMover takes commands.
    void MoverIsReady();

    // Writes the answer to the packet `request` holds.  REQUIRES: `out` is empty and has room for
    // RC_MAX_PACKET bytes.
    void Answer(const RcFramer& request, RcWriter* out);

    // The answer to bytes that are no packet; the connection ends with it.
    void AnswerBroken(const std::string& error, RcWriter* out);

    // Tells a client that all `places` are taken by clients that have spoken in the last `seconds`.
    // The connection is closed afterwards.  `request` may be null: the client has sent none.
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
    int state_;  // MoverState as far as known here; -1: not heard of yet
    Sint32 keyFrame_;
    Sint32 speed_[MAX_JOINTS];  // as set last by remote control (Hohl 2004, 5.3.6)
    Sint32 acceleration_[MAX_JOINTS];
    std::string error_;  // of the request at hand
    MtnFile motion_;     // read to check it; a member because its parts are large
};

#endif  // RequestHandler_h_DEFINED
