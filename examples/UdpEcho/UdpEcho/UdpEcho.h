//
// UdpEcho sends each datagram back to its sender.
//
// The object repeats two steps for ever: receive, send.  One endpoint serves all clients.
//

#ifndef UdpEcho_h_DEFINED
#define UdpEcho_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <ant.h>

#include "def.h"

class UdpEcho : public OObject {
public:
    UdpEcho();
    virtual ~UdpEcho() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReceiveCont(ANTENVMSG msg);
    void SendCont(ANTENVMSG msg);

private:
    static const int PORT = 7001;
    static const int BUFFER_SIZE = 4096;  // bytes; the rest of a larger datagram is lost

    OStatus Bind();
    void Receive();

    antStackRef ipstack_;
    antModuleRef endpoint_;
    antSharedBuffer buffer_;
    byte* data_;
    bool isOpen_;
};

#endif  // UdpEcho_h_DEFINED
