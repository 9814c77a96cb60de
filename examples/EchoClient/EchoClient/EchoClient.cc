#include "EchoClient.h"

#include <EndpointTypes.h>
#include <OPENR/OSyslog.h>
#include <TCPEndpointMsg.h>

#include <stdio.h>
#include <string.h>

#include "entry.h"

static const char* const CONFIG_FILE = "/MS/OPEN-R/MW/CONF/ECHO.CFG";

static const char* const LINES[] = {"one\n", "two\n", "three, and that is all\n"};
static const int NUM_LINES = sizeof(LINES) / sizeof(LINES[0]);

EchoClient::EchoClient()
    : serverPort_(0), sendData_(0), receiveData_(0), line_(0), isStopped_(false)
{
    for (int i = 0; i < numOfSubject; i++) subject[i] = 0;
    for (int i = 0; i < numOfObserver; i++) observer[i] = 0;
}

OStatus
EchoClient::DoInit(const OSystemEvent&)
{
    ipstack_ = antStackRef("IPStack");
    if (ReadConfig() != oSUCCESS) return oFAIL;
    return NewBuffer();
}

OStatus
EchoClient::DoStart(const OSystemEvent&)
{
    if (sendData_ != 0) Connect();
    return oSUCCESS;
}

OStatus
EchoClient::DoStop(const OSystemEvent&)
{
    isStopped_ = true;
    return oSUCCESS;
}

OStatus
EchoClient::DoDestroy(const OSystemEvent&)
{
    return oSUCCESS;
}

// Reads address and port from the first line that is no comment.
OStatus
EchoClient::ReadConfig()
{
    FILE* file = fopen(CONFIG_FILE, "r");
    if (file == 0) {
        OSYSLOG1((osyslogERROR, "EchoClient: %s is not on the Memory Stick", CONFIG_FILE));
        return oFAIL;
    }
    char text[80];
    char address[16] = "";
    int port = 0;
    while (port == 0 && fgets(text, sizeof(text), file) != 0) {
        if (text[0] != '#') sscanf(text, "%15s %d", address, &port);
    }
    fclose(file);
    serverAddress_ = IPAddress(address);
    serverPort_ = (Port)port;
    if (serverAddress_ != IP_ADDR_ANY && port > 0 && port <= 65535) return oSUCCESS;
    OSYSLOG1((osyslogERROR, "EchoClient: %s: no line with address and port, like 10.0.1.2 7000",
              CONFIG_FILE));
    return oFAIL;
}

OStatus
EchoClient::NewBuffer()
{
    antEnvCreateSharedBufferMsg create(BUFFER_SIZE);
    create.Call(ipstack_, sizeof(create));
    if (create.error != ANT_SUCCESS) {
        OSYSLOG1((osyslogERROR, "EchoClient: no shared buffer, error %d", (int)create.error));
        return oFAIL;
    }
    buffer_ = create.buffer;
    buffer_.Map();
    sendData_ = (byte*)buffer_.GetAddress();
    receiveData_ = sendData_ + BUFFER_SIZE / 2;
    return oSUCCESS;
}

// Connects from the local port IP_PORT_ANY, which lets the stack choose a port.
void
EchoClient::Connect()
{
    antEnvCreateEndpointMsg create(EndpointType_TCP, 2 * BUFFER_SIZE);
    create.Call(ipstack_, sizeof(create));
    if (create.error != ANT_SUCCESS) {
        OSYSLOG1((osyslogERROR, "EchoClient: no endpoint, error %d", (int)create.error));
        return;
    }
    endpoint_ = create.moduleRef;
    TCPEndpointConnectMsg connect(endpoint_, IP_ADDR_ANY, IP_PORT_ANY, serverAddress_,
                                  serverPort_);
    connect.Send(ipstack_, myOID_, Extra_Entry[entryConnectCont], sizeof(connect));
}

void
EchoClient::ConnectCont(ANTENVMSG msg)
{
    TCPEndpointConnectMsg* connect = (TCPEndpointConnectMsg*)antEnvMsg::Receive(msg);
    if (isStopped_) return;
    char address[16];
    serverAddress_.GetAsString(address);
    if (connect->error != TCP_SUCCESS) {
        OSYSPRINT(("EchoClient: no server at %s, error %d%s\n", address, (int)connect->error,
                   connect->error == TCP_PORT_UNREACHABLE ? ": nobody listens there" : ""));
        Close();
        return;
    }
    OSYSPRINT(("EchoClient: connected with %s\n", address));
    SendLine();
}

void
EchoClient::SendLine()
{
    const int size = (int)strlen(LINES[line_]);
    memcpy(sendData_, LINES[line_], size);
    TCPEndpointSendMsg send(endpoint_, sendData_, size);
    send.Send(ipstack_, myOID_, Extra_Entry[entrySendCont], sizeof(send));
}

// Receives the whole line: with equal sizeMin and sizeMax, the answer comes when all its bytes are
// there, in however many pieces they arrive.
void
EchoClient::SendCont(ANTENVMSG msg)
{
    TCPEndpointSendMsg* send = (TCPEndpointSendMsg*)antEnvMsg::Receive(msg);
    if (isStopped_) return;
    if (send->error != TCP_SUCCESS) {
        OSYSPRINT(("EchoClient: send failed, error %d\n", (int)send->error));
        Close();
        return;
    }
    TCPEndpointReceiveMsg receive(endpoint_, receiveData_, send->size, send->size);
    receive.Send(ipstack_, myOID_, Extra_Entry[entryReceiveCont], sizeof(receive));
}

void
EchoClient::ReceiveCont(ANTENVMSG msg)
{
    TCPEndpointReceiveMsg* receive = (TCPEndpointReceiveMsg*)antEnvMsg::Receive(msg);
    if (isStopped_) return;
    if (receive->error != TCP_SUCCESS) {
        OSYSPRINT(("EchoClient: the server has gone, error %d\n", (int)receive->error));
        Close();
        return;
    }
    const bool isSame = memcmp(receiveData_, sendData_, receive->sizeMin) == 0;
    OSYSPRINT(("EchoClient: %s %s", isSame ? "back came" : "NOT the same:", LINES[line_]));
    if (++line_ < NUM_LINES) {
        SendLine();
    } else {
        Close();
    }
}

void
EchoClient::Close()
{
    TCPEndpointCloseMsg close(endpoint_);
    close.Send(ipstack_, myOID_, Extra_Entry[entryCloseCont], sizeof(close));
}

void
EchoClient::CloseCont(ANTENVMSG msg)
{
    antEnvMsg::Receive(msg);
    if (!isStopped_) OSYSPRINT(("EchoClient: closed\n"));
}
