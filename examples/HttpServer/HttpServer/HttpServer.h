//
// HttpServer shows the angles of the joints as a web page.
//
//   HttpServer.Sensor <- OVirtualRobotComm.Sensor
//
// GET /        a page that loads itself again every second
// GET /joints  the same as plain text: frame number, then name and degrees
//
// Two browsers are served at a time, each request on a connection of its own.
//

#ifndef HttpServer_h_DEFINED
#define HttpServer_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <OPENR/ODataFormats.h>
#include <ant.h>

#include "JointTable.h"
#include "def.h"

class HttpServer : public OObject {
public:
    HttpServer();
    virtual ~HttpServer() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifySensor(const ONotifyEvent& event);

    void ListenCont(ANTENVMSG msg);
    void ReceiveCont(ANTENVMSG msg);
    void SendCont(ANTENVMSG msg);
    void CloseCont(ANTENVMSG msg);

private:
    static const int PORT = 8080;
    static const int NUM_CONNECTIONS = 2;
    static const int REQUEST_SIZE = 2048;  // bytes, including the headers that browsers send
    static const int HTTP_HEADER_SIZE = 256;  // bytes of the header of an answer, at most
    static const int ANSWER_SIZE = 4096;

    struct Connection {
        antModuleRef endpoint;
        antSharedBuffer buffer;
        char* request;  // REQUEST_SIZE bytes for the request, then ANSWER_SIZE bytes for the answer
        char* answer;
        int requestSize;  // bytes of the request received so far
    };

    // ---- Functions in HttpServer.cc
    OStatus OpenJoints();
    void FindElements(OSensorFrameVectorData* vector);
    int Answer(const char* request, char* answer) const;
    int WriteJoints(bool isPage, char* text) const;

    // ---- Functions in HttpServerNet.cc
    OStatus NewBuffers();
    void Listen(int index);
    void Receive(int index);
    void Send(int index, int size);
    void Close(int index);

    OPrimitiveID joint_[NUM_JOINTS];
    int element_[NUM_JOINTS];  // index of each joint's element in the sensor vector
    bool isFound_;
    slongword angle_[NUM_JOINTS];  // newest angles, in 10^-6 rad
    longword frame_;               // frame number of these angles

    antStackRef ipstack_;
    Connection connection_[NUM_CONNECTIONS];
    bool isStopped_;
};

#endif  // HttpServer_h_DEFINED
