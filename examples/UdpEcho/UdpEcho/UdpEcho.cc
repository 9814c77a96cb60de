#include "UdpEcho.h"

#include <EndpointTypes.h>
#include <OPENR/OSyslog.h>
#include <UDPEndpointMsg.h>

#include "entry.h"

UdpEcho::UdpEcho() : data_(0), isOpen_(false)
{
    for (int i = 0; i < numOfSubject; i++) subject[i] = 0;
    for (int i = 0; i < numOfObserver; i++) observer[i] = 0;
}

OStatus
UdpEcho::DoInit(const OSystemEvent&)
{
    ipstack_ = antStackRef("IPStack");
    antEnvCreateSharedBufferMsg create(BUFFER_SIZE);
    create.Call(ipstack_, sizeof(create));
    if (create.error != ANT_SUCCESS) {
        OSYSLOG1((osyslogERROR, "UdpEcho: no shared buffer, error %d", (int)create.error));
        return oFAIL;
    }
    buffer_ = create.buffer;
    buffer_.Map();
    data_ = (byte*)buffer_.GetAddress();
    return oSUCCESS;
}

OStatus
UdpEcho::DoStart(const OSystemEvent&)
{
    if (Bind() != oSUCCESS) return oFAIL;
    OSYSPRINT(("UdpEcho: listening on UDP port %d\n", PORT));
    isOpen_ = true;
    Receive();
    return oSUCCESS;
}

// The receive that is under way is answered with an error, which finds isOpen_ false.
OStatus
UdpEcho::DoStop(const OSystemEvent&)
{
    if (!isOpen_) return oSUCCESS;
    isOpen_ = false;
    UDPEndpointCloseMsg close(endpoint_);
    close.Call(ipstack_, sizeof(close));
    return oSUCCESS;
}

// A buffer can be given back when it is no longer mapped.
OStatus
UdpEcho::DoDestroy(const OSystemEvent&)
{
    if (data_ == 0) return oSUCCESS;
    buffer_.UnMap();
    antEnvDestroySharedBufferMsg destroy(buffer_);
    destroy.Call(ipstack_, sizeof(destroy));
    return oSUCCESS;
}

// Call() holds up the whole object, so it is for what is answered at once, as a bind is.
OStatus
UdpEcho::Bind()
{
    antEnvCreateEndpointMsg create(EndpointType_UDP, 2 * BUFFER_SIZE);
    create.Call(ipstack_, sizeof(create));
    if (create.error != ANT_SUCCESS) {
        OSYSLOG1((osyslogERROR, "UdpEcho: no endpoint, error %d", (int)create.error));
        return oFAIL;
    }
    endpoint_ = create.moduleRef;
    UDPEndpointBindMsg bind(endpoint_, IP_ADDR_ANY, PORT);
    bind.Call(ipstack_, sizeof(bind));
    if (bind.error == UDP_SUCCESS) return oSUCCESS;
    OSYSLOG1((osyslogERROR, "UdpEcho: cannot bind port %d, error %d", PORT, (int)bind.error));
    return oFAIL;
}

void
UdpEcho::Receive()
{
    UDPEndpointReceiveMsg receive(endpoint_, data_, BUFFER_SIZE);
    receive.Send(ipstack_, myOID_, Extra_Entry[entryReceiveCont], sizeof(receive));
}

// The answer says where the datagram came from and how long it is.
void
UdpEcho::ReceiveCont(ANTENVMSG msg)
{
    UDPEndpointReceiveMsg* receive = (UDPEndpointReceiveMsg*)antEnvMsg::Receive(msg);
    if (!isOpen_) return;
    if (receive->error != UDP_SUCCESS) {
        OSYSLOG1((osyslogERROR, "UdpEcho: receive failed, error %d", (int)receive->error));
        return;  // another try would fail as fast
    }
    char address[16];
    OSYSPRINT(("UdpEcho: %d bytes from %s\n", receive->size,
               receive->address.GetAsString(address)));
    if (receive->size == 0) {  // an empty datagram is legal, an empty send is not
        Receive();
        return;
    }
    UDPEndpointSendMsg send(endpoint_, receive->address, receive->port, data_, receive->size);
    send.Send(ipstack_, myOID_, Extra_Entry[entrySendCont], sizeof(send));
}

// The buffer is ours again.  A datagram that could not be sent is lost like any other.
void
UdpEcho::SendCont(ANTENVMSG msg)
{
    UDPEndpointSendMsg* send = (UDPEndpointSendMsg*)antEnvMsg::Receive(msg);
    if (!isOpen_) return;
    if (send->error != UDP_SUCCESS) {
        OSYSLOG1((osyslogWARNING, "UdpEcho: send failed, error %d", (int)send->error));
    }
    Receive();
}
