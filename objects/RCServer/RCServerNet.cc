//
// The network side of RCServer.
//

#include "RCServer.h"

#include <EndpointTypes.h>
#include <OPENR/OSyslog.h>
#include <TCPEndpointMsg.h>

#include "entry.h"

// Size, in bytes, of the part of a client's shared buffer that holds received bytes.
static const int RECEIVE_SIZE = RC_MAX_PACKET;

// Size, in bytes, of the part of a client's shared buffer that holds the bytes to send.
static const int SEND_SIZE = ClientSession::SEND_SIZE;

// Memory of an endpoint, in bytes: twice the largest send, as in Sony's samples (network guide,
// chapter 1).
static const int ENDPOINT_POOL_SIZE = 2 * SEND_SIZE;

// Time between two tries to listen: one second, in frames of 8 ms.
static const Uint32 RETRY_FRAMES = 125;

// Time, in frames of 8 ms, after which a silent client may lose its place to a waiting client.
// RETRY_FRAMES are one second.
static const Uint32 IDLE_FRAMES = RC_IDLE_SECONDS * RETRY_FRAMES;

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

// Listens for a client.  The data of this client will be in client_[index].  On failure
// client_[index] stays closed, and RetryListening() tries again.
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
    client.session.Begin(index, &handler_);
    client.isReceiving = false;
    client.isSending = false;
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
        // Skips a place without a buffer, because this is the place for a waiting client.
        // ListenForMore() opens this place.
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
        if (client_[i].state == clientOPEN && !client_[i].session.IsWaiting()) count++;
    }
    return count;
}

// Gives the waiting client a place: a free place, or the place of the client that has been silent
// for the longest time.  Silent clients keep their places while no client waits.
void
RCServer::PlaceWaiting(Uint32 frame)
{
    int waiting = -1;
    int silent = -1;
    for (int i = 0; i < NUM_CLIENTS; i++) {
        // Skips a client from which RCServer does not wait for bytes now: this client has sent
        // requests, and their answers are on their way, so it is not silent.
        if (client_[i].state != clientOPEN || !client_[i].isReceiving) continue;
        if (client_[i].session.IsWaiting()) {
            waiting = i;
        } else if (silent < 0 ||
                   frame - client_[i].lastFrame > frame - client_[silent].lastFrame) {
            silent = i;
        }
    }
    if (isStopped_ || waiting < 0) return;
    if (NumServed() < RC_PLACES) {
        client_[waiting].session.SetWaiting(false);
    } else if (silent >= 0 && frame - client_[silent].lastFrame >= IDLE_FRAMES) {
        OSYSLOG1((osyslogWARNING, "RCServer: client %d was silent for %u s and gives way to another",
                  silent, (frame - client_[silent].lastFrame) / RETRY_FRAMES));
        Close(silent);
        client_[waiting].session.SetWaiting(false);
    } else if (frame - client_[waiting].lastFrame >= IDLE_FRAMES) {
        TurnAway(waiting);  // frees the connection, because other clients may want to connect
    }
}

// Tells client `index` that all places are taken, and ends its connection.  Called when this
// client, which waits for a place, has sent nothing for RC_IDLE_SECONDS.  A waiting client that
// sends a request gets the same answer from ClientSession.
void
RCServer::TurnAway(int index)
{
    OSYSLOG1((osyslogWARNING, "RCServer: client %d is turned away, all %d places are taken", index,
              RC_PLACES));
    Send(index, client_[index].session.TurnAway(client_[index].sendData));
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
        // Gives the endpoint back, because RetryListening() makes a new one at each try.
        Close(index);
        client_[index].state = clientFAILED;
        return;
    }
    client_[index].lastFrame = sensors_.frame;
    client_[index].session.SetWaiting(NumServed() >= RC_PLACES);
    client_[index].state = clientOPEN;
    Receive(index);
    PlaceWaiting(sensors_.frame);
    ListenForMore();
}

void
RCServer::Receive(int index)
{
    Client& client = client_[index];
    // Asks for at least 1 byte, and so takes whatever has arrived, because nothing is known of the
    // size of the next packet.
    TCPEndpointReceiveMsg receive(client.endpoint, client.receiveData, 1, RECEIVE_SIZE);
    receive.continuation = Continuation(index);
    receive.Send(ipstack_, myOID_, Extra_Entry[entryReceiveCont], sizeof(receive));
    client.isReceiving = true;
}

void
RCServer::ReceiveCont(ANTENVMSG msg)
{
    const TCPEndpointReceiveMsg* receive = (TCPEndpointReceiveMsg*)antEnvMsg::Receive(msg);
    const int index = IndexOf(receive);
    if (isStopped_ || client_[index].state != clientOPEN) return;
    client_[index].isReceiving = false;
    if (receive->error == TCP_SUCCESS) {
        client_[index].lastFrame = sensors_.frame;
        client_[index].session.Receive(client_[index].receiveData, receive->sizeMin);
        Serve(index);
    } else if (client_[index].isSending) {
        // Closes the connection later, when the bytes that are being sent have arrived.
        client_[index].session.SetLast();
    } else {
        Close(index);  // closes the connection, which the client has usually closed already
    }
}

// Sends answers to the requests that have arrived completely.  If no request is complete, sends the
// packets of streams that are due.  Does nothing while a send runs, because the end of that send
// calls this function again.
void
RCServer::Serve(int index)
{
    Client& client = client_[index];
    if (client.isSending) return;
    const bool wasWaiting = client.session.IsWaiting();
    int size = client.session.NextAnswers(client.sendData);
    if (!client.session.Error().empty()) {
        OSYSLOG1((osyslogWARNING, "RCServer: client %d closed: %s", index,
                  client.session.Error().c_str()));
    } else if (wasWaiting && size > 0) {
        OSYSLOG1((osyslogWARNING, "RCServer: client %d is turned away, all %d places are taken",
                  index, RC_PLACES));
    }
    // Receives only after all requests are answered, because ClientSession has no room for more
    // bytes before that.  So RCServer reads nothing from a client that takes no answers.
    if (size == 0 && !client.isReceiving) Receive(index);
    if (size == 0) size = client.session.NextEvents(client.sendData);
    if (size > 0) Send(index, size);
}

// Sends the due packets of streams to all clients that have subscribed.
void
RCServer::SendEvents()
{
    if (isStopped_) return;
    for (int i = 0; i < NUM_CLIENTS; i++) {
        if (client_[i].state == clientOPEN && handler_.HasEvents(i)) Serve(i);
    }
}

void
RCServer::Send(int index, int size)
{
    Client& client = client_[index];
    TCPEndpointSendMsg send(client.endpoint, client.sendData, size);
    send.continuation = Continuation(index);
    send.Send(ipstack_, myOID_, Extra_Entry[entrySendCont], sizeof(send));
    client.isSending = true;
}

void
RCServer::SendCont(ANTENVMSG msg)
{
    const TCPEndpointSendMsg* send = (TCPEndpointSendMsg*)antEnvMsg::Receive(msg);
    const int index = IndexOf(send);
    if (isStopped_ || client_[index].state != clientOPEN) return;
    client_[index].isSending = false;
    if (send->error == TCP_SUCCESS && !client_[index].session.IsLast()) {
        Serve(index);
        return;
    }
    // The client has asked for shutdown or reboot, which follows even if the answer could not be
    // sent.
    if (client_[index].session.EndsRun()) {
        isShutdownDue_ = true;
        endFrame_ = sensors_.frame;
    }
    Close(index);
}

void
RCServer::Close(int index)
{
    Client& client = client_[index];
    client.session.End();
    TCPEndpointCloseMsg close(client.endpoint);
    close.continuation = Continuation(index);
    close.Send(ipstack_, myOID_, Extra_Entry[entryCloseCont], sizeof(close));
    client.state = clientCLOSING;
}

// Listens for the next client with a new endpoint, because an endpoint serves only one connection.
// If listening has failed, RetryListening() tries again later.
void
RCServer::CloseCont(ANTENVMSG msg)
{
    const int index = IndexOf(antEnvMsg::Receive(msg));
    const bool hasFailed = client_[index].state == clientFAILED;
    client_[index].state = clientCLOSED;
    if (!isStopped_ && !hasFailed) Listen(index);
}
