//
// EchoServer sends all bytes that it receives over TCP back to the client, for two clients at a
// time.
//
// Each connection repeats these operations: listen, receive, send, receive, ... close, listen.  At
// most one operation of a connection is pending, and its answer comes to an entry of this object.
//

#ifndef EchoServer_h_DEFINED
#define EchoServer_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <ant.h>

#include "def.h"

class EchoServer : public OObject {
public:
    EchoServer();
    virtual ~EchoServer() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ListenCont(ANTENVMSG msg);
    void ReceiveCont(ANTENVMSG msg);
    void SendCont(ANTENVMSG msg);
    void CloseCont(ANTENVMSG msg);

private:
    static const int PORT = 7000;
    static const int NUM_CONNECTIONS = 2;

    // Size of a buffer in bytes.  The robot sends up to 1024 bytes at once; of 1025 to 3072 bytes
    // the last part would be sent 200 ms later (Nagle's algorithm).
    static const int BUFFER_SIZE = 1024;

    struct Connection {
        antModuleRef endpoint;
        antSharedBuffer buffer;
        byte* data;  // BUFFER_SIZE bytes; belongs to the stack while an operation is pending
        int numEchoed;
    };

    OStatus NewBuffers();
    void Listen(int index);
    void Receive(int index);
    void Send(int index, int size);
    void Close(int index);

    antStackRef ipstack_;
    Connection connection_[NUM_CONNECTIONS];
    bool isStopped_;
};

#endif  // EchoServer_h_DEFINED
