//
// EchoClient connects to the echo server that ECHO.CFG names, sends three lines, one after the
// other, and checks that they come back unchanged.
//

#ifndef EchoClient_h_DEFINED
#define EchoClient_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <IPv4Types.h>
#include <ant.h>

#include "def.h"

class EchoClient : public OObject {
public:
    EchoClient();
    virtual ~EchoClient() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ConnectCont(ANTENVMSG msg);
    void SendCont(ANTENVMSG msg);
    void ReceiveCont(ANTENVMSG msg);
    void CloseCont(ANTENVMSG msg);

private:
    static const int BUFFER_SIZE = 256;  // bytes; the first half is for sending, the second half
                                         // for receiving

    OStatus ReadConfig();
    OStatus NewBuffer();
    void Connect();
    void SendLine();
    void Close();

    IPAddress serverAddress_;
    Port serverPort_;
    antStackRef ipstack_;
    antModuleRef endpoint_;
    antSharedBuffer buffer_;
    byte* sendData_;
    byte* receiveData_;
    int line_;  // index of the line that was sent last
    bool isStopped_;
};

#endif  // EchoClient_h_DEFINED
