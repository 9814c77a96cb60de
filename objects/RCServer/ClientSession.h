//
// ClientSession: the connection of one client, without the network.  It accepts the bytes that
// arrive and returns the bytes to send next.
//
//   session.Receive(bytes, size);            // bytes have arrived
//   size = session.NextAnswers(buffer);      // while nothing is being sent
//   if (size == 0) size = session.NextEvents(buffer);
//
// Answers come before packets of streams.  All answers are sent in the order of their requests.
//
// Packets of streams have the values to which a client has subscribed.  When packets of streams
// were sent, no more of them are sent until the client has sent a packet.  Usually the client's
// packet is an EVENT packet, which has no answer.  The client's packet shows that no bytes are on
// their way to the client, so neither a slow client nor Nagle's algorithm delays the answers that
// follow.  A client that sends nothing gets packets of streams only every EVENT_FRAMES.
//

#ifndef ClientSession_h_DEFINED
#define ClientSession_h_DEFINED

#include "RequestHandler.h"

// Maximum number of clients that are served at the same time.
const int RC_PLACES = 8;

// Time, in seconds, after which a client that has sent nothing loses its place to a waiting client.
const int RC_IDLE_SECONDS = 10;

class ClientSession {
public:
    // Size of the buffer for NextAnswers() and NextEvents(), in bytes.  One send has at most
    // RC_MAX_PACKET bytes, at the beginning of the buffer.  An answer that does not fit into this
    // send is kept in the buffer, behind these bytes, until the next send.
    static const int SEND_SIZE = 2 * RC_MAX_PACKET;

    ClientSession() : handler_(0), number_(0) { Reset(); }

    // Begins the session of a client.  `number` is the index of the client in the tables of
    // `handler`.
    void Begin(int number, RequestHandler* handler);

    // Ends the upload, the subscriptions and the picture of the client.
    void End() { handler_->EndClient(number_); }

    // Receives bytes that the client has sent, so that NextAnswers() can answer the requests in
    // them.  REQUIRES: size <= RC_MAX_PACKET, and NextAnswers() has returned 0 since the last call.
    void Receive(const Uint8* bytes, int size);

    // Answers requests that have arrived completely, as many as one send has room for.  Writes the
    // answers to `buffer`, which must be the same in each call, and returns their size.  Returns 0
    // if no request is complete.
    int NextAnswers(Uint8* buffer);

    // Writes the packets that are due for the client's subscriptions to `buffer` and returns their
    // size.  Returns 0 if no packet is due.  REQUIRES: NextAnswers() has just returned 0.
    int NextEvents(Uint8* buffer);

    // Writes to `buffer` an answer that says that the server has too many clients to serve this
    // client, and returns its size.  The session ends after this answer.  Used when the client has
    // sent no request.
    int TurnAway(Uint8* buffer) { return TurnAway(buffer, 0); }

    // Returns whether the connection must be closed now: the last answer was made, and no part of
    // it is left to send.
    bool IsLast() const { return isLast_ && heldSize_ == 0; }
    void SetLast() { isLast_ = true; }

    // Returns whether a request has asked for shutdown or reboot of the robot.
    bool EndsRun() const { return endsRun_; }

    // Returns whether the client waits for a place, because all RC_PLACES places are taken.  The
    // first request of a waiting client is answered with an error that says so.
    bool IsWaiting() const { return isWaiting_; }
    void SetWaiting(bool waiting) { isWaiting_ = waiting; }

    // Returns the reason why the bytes of the client are no packet; "" when they are packets.
    const std::string& Error() const { return framer_.Error(); }

private:
    // Time between packets of subscriptions to a client that sends nothing, in frames of 8 ms: 224
    // ms.  The time is longer than the 200 ms within which the client's host acknowledges all
    // earlier bytes (network.md 4.3), so no packet is held back until an acknowledgement comes.
    static const Uint32 EVENT_FRAMES = 28;

    void Reset();
    int TurnAway(Uint8* buffer, const RcFramer* request);
    bool IsAcknowledgement() const;

    RequestHandler* handler_;
    int number_;
    RcFramer framer_;
    bool isLast_;
    bool endsRun_;
    bool isWaiting_;
    // Whether the client has sent a packet after the newest packet of a subscription was sent to
    // it.  If so, the next packet need not wait EVENT_FRAMES.
    bool hasSpoken_;
    Uint32 eventFrame_;  // frame in which the newest packet of a subscription was sent
    int heldAt_;         // offset in the buffer of an answer that did not fit into the last send
    int heldSize_;  // size of the answer at heldAt_; 0 if there is no such answer
};

#endif  // ClientSession_h_DEFINED
