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

// Marks the socket as closed and closes it.  The pending receive is answered with an error, which
// has no effect then.
OStatus
UdpEcho::DoStop(const OSystemEvent&)
{
    if (!isOpen_) return oSUCCESS;
    isOpen_ = false;
    UDPEndpointCloseMsg close(endpoint_);
    close.Call(ipstack_, sizeof(close));
    return oSUCCESS;
}

// Unmaps the buffers before they are given back, because a mapped buffer cannot be given back.
OStatus
UdpEcho::DoDestroy(const OSystemEvent&)
{
    if (data_ == 0) return oSUCCESS;
    buffer_.UnMap();
    antEnvDestroySharedBufferMsg destroy(buffer_);
    destroy.Call(ipstack_, sizeof(destroy));
    return oSUCCESS;
}

// Binds the port with Call(), which stops the whole object until the answer comes.  This is good
// for requests that are answered at once, such as a bind.
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

// Sends the datagram back.  The answer of the stack has its sender and its size.
void
UdpEcho::ReceiveCont(ANTENVMSG msg)
{
    UDPEndpointReceiveMsg* receive = (UDPEndpointReceiveMsg*)antEnvMsg::Receive(msg);
    if (!isOpen_) return;
    if (receive->error != UDP_SUCCESS) {
        OSYSLOG1((osyslogERROR, "UdpEcho: receive failed, error %d", (int)receive->error));
        return;  // another attempt would fail as fast
    }
    char address[16];
    OSYSPRINT(("UdpEcho: %d bytes from %s\n", receive->size,
               receive->address.GetAsString(address)));
    if (receive->size == 0) {  // an empty datagram may be received, but not be sent
        Receive();
        return;
    }
    UDPEndpointSendMsg send(endpoint_, receive->address, receive->port, data_, receive->size);
    send.Send(ipstack_, myOID_, Extra_Entry[entrySendCont], sizeof(send));
}

// Receives the next datagram, because the buffer belongs to this object again.  A datagram that
// could not be sent is lost, as in any UDP network.
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
