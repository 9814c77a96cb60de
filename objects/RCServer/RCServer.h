//
// RCServer serves remote clients over TCP (docs/remote-control.md).
//
//   RCServer.Mover    -> JointMover: commands for joints, motions
//   RCServer.LedEar   -> Controller, which commands LEDs and ears
//   RCServer.Sensor   <- sensor values, and the frame number that every answer has
//   RCServer.SetValue <- state and key frame of JointMover
//   RCServer.Image    <- images of the camera, while a client waits for a picture
//
// Each client has an endpoint (a TCP connection of the robot's network) and a buffer in shared
// memory.  Each connection has at most one Receive and one Send message under way.  An error ends
// only the connection on which it occurs.  ClientSession and RequestHandler know the meaning of the
// bytes; this class transports bytes and messages.
//

#ifndef RCServer_h_DEFINED
#define RCServer_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <ant.h>

#include "ClientSession.h"
#include "MoverQueue.h"
#include "SensorReader.h"
#include "def.h"

class RCServer : public OObject, private RequestPort {
public:
    RCServer();
    virtual ~RCServer() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadyMover(const OReadyEvent& event);
    void ReadyLedEar(const OReadyEvent& event);
    void NotifySensor(const ONotifyEvent& event);
    void NotifySetValue(const ONotifyEvent& event);
    void NotifyImage(const ONotifyEvent& event);

    void ListenCont(ANTENVMSG msg);
    void ReceiveCont(ANTENVMSG msg);
    void SendCont(ANTENVMSG msg);
    void CloseCont(ANTENVMSG msg);

private:
    // Maximum number of connections: RC_PLACES clients that are served, and one client that waits.
    // The waiting client gets the place of a client that has been silent for long, or an answer
    // that says why it gets no place (PlaceWaiting()).
    static const int NUM_CLIENTS = RC_PLACES + 1;
    COMPILE_TIME_CHECK(EveryClientHasAnUpload, NUM_CLIENTS == RequestHandler::MAX_CLIENTS);

    // The end of the run that a client has asked for: none, shutdown or reboot of the robot.
    enum RunEnd { runGOES_ON, runSHUTDOWN, runREBOOT };

    enum ClientState {
        clientCLOSED,
        clientLISTENING,
        clientOPEN,
        clientCLOSING,
        clientFAILED  // listening has failed, and the endpoint is being closed
    };

    struct Client {
        ClientState state;
        antModuleRef endpoint;
        antSharedBuffer buffer;
        byte* receiveData;
        byte* sendData;
        ClientSession session;
        bool isReceiving;  // whether a Receive message to the network waits for its answer
        bool isSending;    // whether a Send message to the network waits for its answer
        Uint32 lastFrame;  // frame in which the client last sent bytes
    };

    // The functions of RequestPort, which RequestHandler calls.
    virtual bool PostMover(const MoverCommand& command);
    virtual void PostLedEar(const LedEarState& change);
    virtual bool ReadFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error);
    virtual void ReadBattery(Sint32* capacity, Sint32* temperature);
    virtual bool ReadPower(RcPower* power);
    virtual bool ReadGains(int joint, Uint16 gains[6]);
    virtual void WantImage(bool wanted);
    virtual void EndRun(bool reboot);

    OStatus NewBuffer(int index);
    void Listen(int index);
    void ListenForMore();
    void Receive(int index);
    void Serve(int index);
    void SendEvents();
    void Send(int index, int size);
    void Close(int index);
    void RetryListening(Uint32 frame);
    int NumServed() const;
    void PlaceWaiting(Uint32 frame);
    void TurnAway(int index);
    void SendMover();
    void SendLedEar();
    void ShutDownWhenDue(Uint32 frame);
    void ShutDownRobot();

    antStackRef ipstack_;
    Client client_[NUM_CLIENTS];
    RequestHandler handler_;
    SensorReader sensorReader_;
    SensorValues sensors_;
    Uint32 retryFrame_;   // frame in which listening was last tried again
    MoverQueue mover_;    // commands that wait until JointMover is ready
    LedEarState ledEar_;  // changes of LEDs and ears that wait until Controller is ready
    RunEnd runEnd_;       // set by a request for shutdown or reboot
    bool isShutdownDue_;  // whether the robot shuts down END_FRAMES after endFrame_
    Uint32 endFrame_;     // frame in which the answer to a request for shutdown or reboot was sent
    bool isStopped_;      // true before DoInit has found the robot, and from DoStop on
};

#endif  // RCServer_h_DEFINED
