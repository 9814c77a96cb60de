//
// The part of RCServer that does not use OPEN-R: makes the answer to a request
// (docs/remote-control.md).
//
// All clients share the robot: when one client sets a limit of speed or acceleration, the limit is
// valid for all, and the last command counts.  Only the upload, the subscriptions and the picture
// belong to a single client.
//

#ifndef RequestHandler_h_DEFINED
#define RequestHandler_h_DEFINED

#include "ClientStreams.h"
#include "FileUpload.h"
#include "MotionLog.h"
#include "MtnFile.h"
#include "PictureSlot.h"
#include "RemoteProtocol.h"
#include "RequestPort.h"
#include "SensorValues.h"

class RequestHandler {
public:
    // Largest number of clients, including clients that wait for a place.
    static const int MAX_CLIENTS = 9;

    // Makes a handler.  `port` must outlive the handler.
    explicit RequestHandler(RequestPort* port);

    // Begins to serve `robot`, and removes temporary files of uploads from an earlier run.
    // `stickRoot` is the path of the folder that has the folder MS of the stick: "" on the robot.
    // Returns "" or the path of a file that could not be removed.
    std::string Begin(const RobotConstants* robot, const std::string& stickRoot = "");

    // Stores the newest sensor values of the robot, for answers.
    void SetSensors(const SensorValues& values);

    // Stores `message`, the newest report of JointMover, for answers.
    void SetMover(const SetValueMessage& message);

    // Returns the layer of the picture that a client waits for; -1 if no client waits.
    int WantedLayer() const { return picture_.IsWaiting() ? picture_.Layer() : -1; }
    // Stores the picture for the client that waits for it.
    void SetPicture(const CameraLayer& layer);

    // Records that JointMover accepts commands.  Called when JointMover has asserted ready.
    void MoverIsReady();

    // Writes to `out` the answer to the packet in `request`, which client number `client` has sent.
    // REQUIRES: `out` is empty and has room for RC_MAX_PACKET bytes; 0 <= client < MAX_CLIENTS.
    void Answer(int client, const RcFramer& request, RcWriter* out);

    // Returns whether the request that was answered last has asked for shutdown or reboot.
    bool EndsRun() const { return endsRun_; }

    // Returns the frame number of the newest sensor values.
    Uint32 Frame() const { return sensors_.frame; }

    // Returns whether a packet for a subscription of the client is due.
    bool HasEvents(int client) const { return streams_[client].Due(sensors_.frame) >= 0; }

    // Writes to `out` all packets that are due for subscriptions of the client.  REQUIRES: `out` is
    // empty and has room for RC_MAX_PACKET bytes.
    void WriteEvents(int client, RcWriter* out);

    // Ends the upload, the subscriptions and the picture of a client whose connection has ended.
    void EndClient(int client);

    // Writes to `out` the answer to bytes that are no packet; `error` is the reason.  The
    // connection ends after this answer.
    void AnswerBroken(const std::string& error, RcWriter* out);

    // Writes to `out` the answer that all `places` are taken by clients that have sent requests in
    // the last `seconds`.  The connection ends after this answer.  `request` is 0 when the client
    // has sent no request.
    void AnswerNoPlace(const RcFramer* request, int places, int seconds, RcWriter* out);

private:
    void BeginAnswer(RcWriter* out, int status);
    void AnswerOne(const RcHeader& request, const Uint8* payload, RcWriter* out);
    int Handle(int command, RcReader* in, RcWriter* out);
    int HandleVersion1(int command, RcReader* in, RcWriter* out);
    int HandleVersion2(int command, RcReader* in, RcWriter* out);
    int CountBatch(RcReader in, int* count);
    int AnswerBatch(RcReader* in, RcWriter* out);
    int ListMotions(RcReader* in, RcWriter* out);
    int BeginUpload(RcReader* in, RcWriter* out);
    int ReceiveUpload(RcReader* in, RcWriter* out);
    int EndUpload(RcReader* in, RcWriter* out);
    int DeleteFile(RcReader* in);
    int Download(RcReader* in, RcWriter* out);
    int EndRun(RcReader* in, bool reboot);
    int SwitchMotor(int command, RcReader* in);
    int SetOrTellGains(RcReader* in, RcWriter* out);
    int SetGains(int joint, RcReader* in, RcGains* gains);
    int TellPower(RcReader* in, RcWriter* out);
    int Subscribe(RcReader* in, RcWriter* out);
    int Unsubscribe(RcReader* in);
    int FailStream(int stream);
    void WriteSensors(RcWriter* out);
    void WriteSetValues(RcWriter* out) const;
    int AskForPicture(RcReader* in);
    int TellPicturePart(RcReader* in, RcWriter* out);
    void EndPicture(int client);
    int TellLog(RcReader* in, RcWriter* out);
    int Describe(RcReader* in, RcWriter* out);
    int GetJoint(RcReader* in, RcWriter* out);
    int CommandJoint(int command, RcReader* in, RcWriter* out);
    int TrackJoint(RcReader* in, RcWriter* out);
    int CommandLight(int command, RcReader* in, RcWriter* out);
    int TellSensors(RcReader* in, RcWriter* out);
    int TellInfo(RcReader* in, RcWriter* out);
    int PlayMotion(RcReader* in, RcWriter* out);
    int StopMotion(RcReader* in);
    int LoadMotion(const std::string& file, MoverCommand* command, RcPlayAnswer* answer);
    int Busy(bool duringMotion);
    int Limp();
    int Post(const MoverCommand& command);
    int Fail(int status, const std::string& why);
    int FailSize();
    int FailKind(int kind);
    int FailIndex(const char* what, int index, int count);
    bool DescribeDevice(int kind, int index, RcDescription* description) const;
    int NumDevices(int kind) const;
    const SensorConstants* FindInGroup(SensorGroup group, int index) const;

    RequestPort* port_;
    const RobotConstants* robot_;
    SensorValues sensors_;
    int state_;  // MoverState in the newest report of JointMover; -1 if there is no report yet
    SetValueMessage report_;  // the newest report of JointMover
    bool motorsOff_;  // whether a client has switched motor power off
    // For each joint, the limit of its speed that the remote control has set last (Hohl 2004,
    // 5.3.6).
    Sint32 speed_[MAX_JOINTS];
    // For each joint, the limit of acceleration that the remote control has set last.
    Sint32 acceleration_[MAX_JOINTS];
    int version_;        // protocol version of the present request
    bool isInBatch_;     // whether the present request is a part of a batch
    int client_;         // client of the present request
    Uint16 tag_;         // tag of the present request
    bool endsRun_;       // whether the present request has asked for shutdown or reboot
    std::string error_;  // error text of the present request
    // The motion file that is checked.  A member, so that its memory is used again for the next
    // file.
    MtnFile motion_;
    MotionLog log_;
    PictureSlot picture_;
    StickStore store_;
    // The part of a file that is being sent; a member, because it is too large for the stack.
    Uint8 part_[RC_MAX_DOWNLOAD_DATA];
    ClientStreams streams_[MAX_CLIENTS];
    // Must be the last member.  For a member behind it, the compiler would add code that destroys
    // the uploads when the constructor of that member throws.  Such code calls std::terminate(),
    // which the robot lacks.
    FileUpload upload_[MAX_CLIENTS];
};

#endif  // RequestHandler_h_DEFINED
