//
// The network side of HttpServer: a request comes in, an answer goes out, the connection ends.
//

#include "HttpServer.h"

#include <EndpointTypes.h>
#include <OPENR/OSyslog.h>
#include <TCPEndpointMsg.h>

#include <string.h>

#include "entry.h"

OStatus
HttpServer::NewBuffers()
{
    for (int i = 0; i < NUM_CONNECTIONS; i++) {
        antEnvCreateSharedBufferMsg create(REQUEST_SIZE + ANSWER_SIZE);
        create.Call(ipstack_, sizeof(create));
        if (create.error != ANT_SUCCESS) {
            OSYSLOG1((osyslogERROR, "HttpServer: no shared buffer, error %d", (int)create.error));
            return oFAIL;
        }
        connection_[i].buffer = create.buffer;
        connection_[i].buffer.Map();
        connection_[i].request = (char*)connection_[i].buffer.GetAddress();
        connection_[i].answer = connection_[i].request + REQUEST_SIZE;
    }
    return oSUCCESS;
}

void
HttpServer::Listen(int index)
{
    antEnvCreateEndpointMsg create(EndpointType_TCP, 2 * ANSWER_SIZE);
    create.Call(ipstack_, sizeof(create));
    if (create.error != ANT_SUCCESS) {
        OSYSLOG1((osyslogERROR, "HttpServer: no endpoint, error %d", (int)create.error));
        return;
    }
    connection_[index].endpoint = create.moduleRef;
    connection_[index].requestSize = 0;
    TCPEndpointListenMsg listen(connection_[index].endpoint, IP_ADDR_ANY, PORT);
    listen.continuation = (void*)(long)index;
    listen.Send(ipstack_, myOID_, Extra_Entry[entryListenCont], sizeof(listen));
}

void
HttpServer::ListenCont(ANTENVMSG msg)
{
    TCPEndpointListenMsg* listen = (TCPEndpointListenMsg*)antEnvMsg::Receive(msg);
    if (isStopped_) return;
    if (listen->error != TCP_SUCCESS) {
        OSYSLOG1((osyslogERROR, "HttpServer: cannot listen, error %d", (int)listen->error));
        return;
    }
    Receive((int)(long)listen->continuation);
}

// Receives more bytes behind those that have arrived, because a request may arrive in pieces.
// Keeps one byte free for a closing zero.
void
HttpServer::Receive(int index)
{
    Connection& connection = connection_[index];
    TCPEndpointReceiveMsg receive(connection.endpoint,
                                  (byte*)connection.request + connection.requestSize, 1,
                                  REQUEST_SIZE - 1 - connection.requestSize);
    receive.continuation = (void*)(long)index;
    receive.Send(ipstack_, myOID_, Extra_Entry[entryReceiveCont], sizeof(receive));
}

// Answers when the request is complete, that is, when it ends with an empty line.
void
HttpServer::ReceiveCont(ANTENVMSG msg)
{
    TCPEndpointReceiveMsg* receive = (TCPEndpointReceiveMsg*)antEnvMsg::Receive(msg);
    if (isStopped_) return;
    const int index = (int)(long)receive->continuation;
    Connection& connection = connection_[index];
    if (receive->error != TCP_SUCCESS) {
        Close(index);
        return;
    }
    connection.requestSize += receive->sizeMin;
    connection.request[connection.requestSize] = '\0';
    if (strstr(connection.request, "\r\n\r\n") != 0) {
        Send(index, Answer(connection.request, connection.answer));
    } else if (connection.requestSize == REQUEST_SIZE - 1) {
        OSYSLOG1((osyslogWARNING, "HttpServer: a request of more than %d bytes", REQUEST_SIZE));
        Close(index);
    } else {
        Receive(index);
    }
}

// Sends header and page at once, 1024 bytes at most.  On the robot, further bytes would be sent up
// to 200 ms later (Nagle's algorithm), and so would a second send.
void
HttpServer::Send(int index, int size)
{
    TCPEndpointSendMsg send(connection_[index].endpoint, (byte*)connection_[index].answer, size);
    send.continuation = (void*)(long)index;
    send.Send(ipstack_, myOID_, Extra_Entry[entrySendCont], sizeof(send));
}

void
HttpServer::SendCont(ANTENVMSG msg)
{
    TCPEndpointSendMsg* send = (TCPEndpointSendMsg*)antEnvMsg::Receive(msg);
    if (!isStopped_) Close((int)(long)send->continuation);
}

void
HttpServer::Close(int index)
{
    TCPEndpointCloseMsg close(connection_[index].endpoint);
    close.continuation = (void*)(long)index;
    close.Send(ipstack_, myOID_, Extra_Entry[entryCloseCont], sizeof(close));
}

void
HttpServer::CloseCont(ANTENVMSG msg)
{
    const int index = (int)(long)antEnvMsg::Receive(msg)->continuation;
    if (!isStopped_) Listen(index);
}
