//
// The network side of RCServer.
//

#include "RCServer.h"

#include <EndpointTypes.h>
#include <OPENR/OSyslog.h>
#include <TCPEndpointMsg.h>

#include "entry.h"

// Sizes, in bytes, of the two parts of a client's shared buffer: received bytes, and answers to
// send.  Answers are collected until they fill a packet, and then one more answer of full size must
// still fit.
static const int RECEIVE_SIZE = RC_MAX_PACKET;
static const int SEND_SIZE = 2 * RC_MAX_PACKET;

// Size, in bytes, that most answers do not exceed.  Requests that arrived together are answered in
// one send, as long as another answer of this size keeps the send below RC_MAX_PACKET.
static const int USUAL_ANSWER_SIZE = 256;

// Memory of an endpoint, in bytes: twice the largest send, as in Sony's samples (network guide,
// chapter 1).
static const int ENDPOINT_POOL_SIZE = 2 * SEND_SIZE;

// Time between two tries to listen: one second, in frames of 8 ms.
static const Uint32 RETRY_FRAMES = 125;

// Time after which a client that has sent nothing loses its place to a waiting client: ten seconds,
// in frames of 8 ms.
static const Uint32 IDLE_FRAMES = 1250;

// Returns the continuation (user data) of a network message: the index of the client to which the
// result of the message belongs.
static void*
Continuation(int index)
{
    return (void*)(long)index;
}

static int
IndexOf(const antEnvMsg* message)
{
    return (int)(long)message->continuation;
}

OStatus
RCServer::NewBuffer(int index)
{
    Client& client = client_[index];
    antEnvCreateSharedBufferMsg create(RECEIVE_SIZE + SEND_SIZE);
    create.Call(ipstack_, sizeof(create));
    if (create.error != ANT_SUCCESS) {
        OSYSLOG1((osyslogERROR, "RCServer: no shared buffer for client %d, error %d", index,
                  (int)create.error));
        return oFAIL;
    }
    client.buffer = create.buffer;
    client.buffer.Map();
    client.receiveData = (byte*)client.buffer.GetAddress();
    client.sendData = client.receiveData + RECEIVE_SIZE;
    return oSUCCESS;
}

// Listens for a client at place `index`.  On failure the place stays closed, and RetryListening()
// tries again.
void
RCServer::Listen(int index)
{
    Client& client = client_[index];
    antEnvCreateEndpointMsg create(EndpointType_TCP, ENDPOINT_POOL_SIZE);
    create.Call(ipstack_, sizeof(create));
    if (create.error != ANT_SUCCESS) {
        OSYSLOG1((osyslogERROR, "RCServer: no endpoint for client %d, error %d", index,
                  (int)create.error));
        return;
    }
    client.endpoint = create.moduleRef;
    client.isLast = false;
    client.isWaiting = false;
    client.endsRun = false;
    client.framer.Reset();
    TCPEndpointListenMsg listen(client.endpoint, IP_ADDR_ANY, RC_PORT);
    listen.continuation = Continuation(index);
    listen.Send(ipstack_, myOID_, Extra_Entry[entryListenCont], sizeof(listen));
    client.state = clientLISTENING;
}

void
RCServer::RetryListening(Uint32 frame)
{
    if (isStopped_ || frame - retryFrame_ < RETRY_FRAMES) return;
    retryFrame_ = frame;
    for (int i = 0; i < NUM_CLIENTS; i++) {
        if (client_[i].state == clientCLOSED && client_[i].receiveData != 0) Listen(i);
    }
}

// Listens with one more endpoint when all places are taken, so that a further client gets an
// answer.
void
RCServer::ListenForMore()
{
    int more = -1;
    for (int i = 0; i < NUM_CLIENTS; i++) {
        if (client_[i].state == clientLISTENING) return;
        if (client_[i].state == clientCLOSED) more = i;
    }
    if (more < 0) return;
    if (client_[more].receiveData == 0 && NewBuffer(more) != oSUCCESS) return;
    Listen(more);
}

int
RCServer::NumServed() const
{
    int count = 0;
    for (int i = 0; i < NUM_CLIENTS; i++) {
        const ClientState state = client_[i].state;
        if ((state == clientRECEIVING || state == clientSENDING) && !client_[i].isWaiting) count++;
    }
    return count;
}

// Gives the waiting client a place: a free place, or that of the client that has been silent for
// the longest time.  Silent clients keep their places while no client waits.
void
RCServer::PlaceWaiting(Uint32 frame)
{
    int waiting = -1;
    int silent = -1;
    for (int i = 0; i < NUM_CLIENTS; i++) {
        if (client_[i].state != clientRECEIVING) continue;
        if (client_[i].isWaiting) {
            waiting = i;
        } else if (silent < 0 ||
                   frame - client_[i].lastFrame > frame - client_[silent].lastFrame) {
            silent = i;
        }
    }
    if (isStopped_ || waiting < 0) return;
    if (NumServed() < NUM_PLACES) {
        client_[waiting].isWaiting = false;
    } else if (silent >= 0 && frame - client_[silent].lastFrame >= IDLE_FRAMES) {
        OSYSLOG1((osyslogWARNING, "RCServer: client %d was silent for %u s and gives way to another",
                  silent, (frame - client_[silent].lastFrame) / RETRY_FRAMES));
        Close(silent);
        client_[waiting].isWaiting = false;
    } else if (frame - client_[waiting].lastFrame >= IDLE_FRAMES) {
        TurnAway(waiting, 0);  // it sent no request, and other clients may want to connect
    }
}

// Answers client `index` that all places are taken, and ends its connection.  `request` is 0 when
// the client has sent none.
void
RCServer::TurnAway(int index, const RcFramer* request)
{
    Client& client = client_[index];
    OSYSLOG1((osyslogWARNING, "RCServer: client %d is turned away, all %d places are taken", index,
              NUM_PLACES));
    RcWriter out(client.sendData, RC_MAX_PACKET);
    handler_.AnswerNoPlace(request, NUM_PLACES, (int)(IDLE_FRAMES / RETRY_FRAMES), &out);
    client.isLast = true;
    Send(index, out.Size());
}

void
RCServer::ListenCont(ANTENVMSG msg)
{
    const TCPEndpointListenMsg* listen = (TCPEndpointListenMsg*)antEnvMsg::Receive(msg);
    const int index = IndexOf(listen);
    if (isStopped_ || client_[index].state != clientLISTENING) return;
    if (listen->error != TCP_SUCCESS) {
        OSYSLOG1((osyslogERROR, "RCServer: cannot listen on TCP port %d, error %d", RC_PORT,
                  (int)listen->error));
        client_[index].state = clientCLOSED;
        return;
    }
    client_[index].lastFrame = sensors_.frame;
    client_[index].isWaiting = NumServed() >= NUM_PLACES;
    Receive(index);
    PlaceWaiting(sensors_.frame);
    ListenForMore();
}

void
RCServer::Receive(int index)
{
    Client& client = client_[index];
    TCPEndpointReceiveMsg receive(client.endpoint, client.receiveData, 1, RECEIVE_SIZE);
    receive.continuation = Continuation(index);
    receive.Send(ipstack_, myOID_, Extra_Entry[entryReceiveCont], sizeof(receive));
    client.state = clientRECEIVING;
}

void
RCServer::ReceiveCont(ANTENVMSG msg)
{
    const TCPEndpointReceiveMsg* receive = (TCPEndpointReceiveMsg*)antEnvMsg::Receive(msg);
    const int index = IndexOf(receive);
    if (isStopped_ || client_[index].state != clientRECEIVING) return;
    if (receive->error != TCP_SUCCESS) {
        Close(index);  // usually because the client has closed the connection
        return;
    }
    client_[index].lastFrame = sensors_.frame;
    client_[index].framer.Take(client_[index].receiveData, receive->sizeMin);
    AnswerRequests(index);
}

// Answers all requests that have arrived completely and sends the answers.  When no request is
// complete, receives more bytes.
void
RCServer::AnswerRequests(int index)
{
    Client& client = client_[index];
    int size = 0;
    while (!client.isLast && size + USUAL_ANSWER_SIZE <= RC_MAX_PACKET) {
        RcWriter out(client.sendData + size, RC_MAX_PACKET);
        const RcFramer::Result result = client.framer.Next();
        if (result == RcFramer::NEEDS_MORE) break;
        if (result == RcFramer::PACKET && client.isWaiting) return TurnAway(index, &client.framer);
        if (result == RcFramer::PACKET) {
            const RunEnd before = runEnd_;
            handler_.Answer(index, client.framer, &out);
            if (runEnd_ != before) client.isLast = client.endsRun = true;
        } else {
            OSYSLOG1((osyslogWARNING, "RCServer: client %d closed: %s", index,
                      client.framer.Error().c_str()));
            handler_.AnswerBroken(client.framer.Error(), &out);
            client.isLast = true;
        }
        size += out.Size();
    }
    if (size > 0) {
        Send(index, size);
    } else {
        Receive(index);
    }
}

void
RCServer::Send(int index, int size)
{
    Client& client = client_[index];
    TCPEndpointSendMsg send(client.endpoint, client.sendData, size);
    send.continuation = Continuation(index);
    send.Send(ipstack_, myOID_, Extra_Entry[entrySendCont], sizeof(send));
    client.state = clientSENDING;
}

void
RCServer::SendCont(ANTENVMSG msg)
{
    const TCPEndpointSendMsg* send = (TCPEndpointSendMsg*)antEnvMsg::Receive(msg);
    const int index = IndexOf(send);
    if (isStopped_ || client_[index].state != clientSENDING) return;
    // Because the client has asked for the end, the run ends also when the answer was not sent.
    if (client_[index].endsRun) {
        isEnding_ = true;
        endFrame_ = sensors_.frame;
    }
    if (send->error != TCP_SUCCESS || client_[index].isLast) {
        Close(index);
    } else {
        AnswerRequests(index);
    }
}

void
RCServer::Close(int index)
{
    Client& client = client_[index];
    handler_.EndClient(index);
    TCPEndpointCloseMsg close(client.endpoint);
    close.continuation = Continuation(index);
    close.Send(ipstack_, myOID_, Extra_Entry[entryCloseCont], sizeof(close));
    client.state = clientCLOSING;
}

// Listens for the next client with a new endpoint, because an endpoint serves only one connection.
void
RCServer::CloseCont(ANTENVMSG msg)
{
    const int index = IndexOf(antEnvMsg::Receive(msg));
    client_[index].state = clientCLOSED;
    if (!isStopped_) Listen(index);
}
