#include "EchoServer.h"

#include <EndpointTypes.h>
#include <OPENR/OSyslog.h>
#include <TCPEndpointMsg.h>

#include "entry.h"

EchoServer::EchoServer() : isStopped_(false)
{
    for (int i = 0; i < numOfSubject; i++) subject[i] = 0;
    for (int i = 0; i < numOfObserver; i++) observer[i] = 0;
    for (int i = 0; i < NUM_CONNECTIONS; i++) {
        connection_[i].data = 0;
        connection_[i].numEchoed = 0;
    }
}

// Makes all buffers here, once, because making buffers is slow.
OStatus
EchoServer::DoInit(const OSystemEvent&)
{
    ipstack_ = antStackRef("IPStack");
    if (!ipstack_.IsValid()) {
        OSYSLOG1((osyslogERROR, "EchoServer: there is no IPStack; is this a WLAN system?"));
        return oFAIL;
    }
    return NewBuffers();
}

OStatus
EchoServer::DoStart(const OSystemEvent&)
{
    for (int i = 0; i < NUM_CONNECTIONS; i++) Listen(i);
    OSYSPRINT(("EchoServer: listening on TCP port %d\n", PORT));
    return oSUCCESS;
}

// Marks the object as stopped.  Answers may still come, but they have no effect any more.
OStatus
EchoServer::DoStop(const OSystemEvent&)
{
    isStopped_ = true;
    return oSUCCESS;
}

OStatus
EchoServer::DoDestroy(const OSystemEvent&)
{
    return oSUCCESS;
}

OStatus
EchoServer::NewBuffers()
{
    for (int i = 0; i < NUM_CONNECTIONS; i++) {
        antEnvCreateSharedBufferMsg create(BUFFER_SIZE);
        create.Call(ipstack_, sizeof(create));
        if (create.error != ANT_SUCCESS) {
            OSYSLOG1((osyslogERROR, "EchoServer: no shared buffer, error %d", (int)create.error));
            return oFAIL;
        }
        connection_[i].buffer = create.buffer;
        connection_[i].buffer.Map();
        connection_[i].data = (byte*)connection_[i].buffer.GetAddress();
    }
    return oSUCCESS;
}

// Listens with a new endpoint for each client, because an endpoint serves only one connection.
// Several endpoints may listen on one port.
void
EchoServer::Listen(int index)
{
    antEnvCreateEndpointMsg create(EndpointType_TCP, 2 * BUFFER_SIZE);
    create.Call(ipstack_, sizeof(create));
    if (create.error != ANT_SUCCESS) {
        OSYSLOG1((osyslogERROR, "EchoServer: no endpoint, error %d", (int)create.error));
        return;
    }
    connection_[index].endpoint = create.moduleRef;
    connection_[index].numEchoed = 0;
    TCPEndpointListenMsg listen(connection_[index].endpoint, IP_ADDR_ANY, PORT);
    listen.continuation = (void*)(long)index;
    listen.Send(ipstack_, myOID_, Extra_Entry[entryListenCont], sizeof(listen));
}

void
EchoServer::ListenCont(ANTENVMSG msg)
{
    TCPEndpointListenMsg* listen = (TCPEndpointListenMsg*)antEnvMsg::Receive(msg);
    if (isStopped_) return;
    const int index = (int)(long)listen->continuation;
    if (listen->error != TCP_SUCCESS) {
        OSYSLOG1((osyslogERROR, "EchoServer: cannot listen, error %d", (int)listen->error));
        return;
    }
    char address[16];
    OSYSPRINT(("EchoServer: %d: connected with %s\n", index,
               listen->fAddress.GetAsString(address)));
    Receive(index);
}

// Receives at least one byte.  TCP has no messages, so any bytes that have arrived may be sent
// back.
void
EchoServer::Receive(int index)
{
    TCPEndpointReceiveMsg receive(connection_[index].endpoint, connection_[index].data, 1,
                                  BUFFER_SIZE);
    receive.continuation = (void*)(long)index;
    receive.Send(ipstack_, myOID_, Extra_Entry[entryReceiveCont], sizeof(receive));
}

// Handles received bytes.  An error usually means that the client has closed its side.
void
EchoServer::ReceiveCont(ANTENVMSG msg)
{
    TCPEndpointReceiveMsg* receive = (TCPEndpointReceiveMsg*)antEnvMsg::Receive(msg);
    if (isStopped_) return;
    const int index = (int)(long)receive->continuation;
    if (receive->error != TCP_SUCCESS) {
        Close(index);
    } else {
        Send(index, receive->sizeMin);  // sizeMin is now the number of bytes received
    }
}

void
EchoServer::Send(int index, int size)
{
    TCPEndpointSendMsg send(connection_[index].endpoint, connection_[index].data, size);
    send.continuation = (void*)(long)index;
    send.Send(ipstack_, myOID_, Extra_Entry[entrySendCont], sizeof(send));
}

// Receives again.  From here on the buffer belongs to this object again, although the client may
// not have received the bytes yet.
void
EchoServer::SendCont(ANTENVMSG msg)
{
    TCPEndpointSendMsg* send = (TCPEndpointSendMsg*)antEnvMsg::Receive(msg);
    if (isStopped_) return;
    const int index = (int)(long)send->continuation;
    if (send->error != TCP_SUCCESS) {
        Close(index);
        return;
    }
    connection_[index].numEchoed += send->size;
    Receive(index);
}

void
EchoServer::Close(int index)
{
    TCPEndpointCloseMsg close(connection_[index].endpoint);
    close.continuation = (void*)(long)index;
    close.Send(ipstack_, myOID_, Extra_Entry[entryCloseCont], sizeof(close));
}

void
EchoServer::CloseCont(ANTENVMSG msg)
{
    const int index = (int)(long)antEnvMsg::Receive(msg)->continuation;
    if (isStopped_) return;
    OSYSPRINT(("EchoServer: %d: closed after %d bytes\n", index, connection_[index].numEchoed));
    Listen(index);
}
