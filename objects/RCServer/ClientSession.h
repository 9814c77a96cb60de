//
// The connection of one client, without the network: takes the bytes that arrive and tells the bytes
// to send next.
//
//   session.Take(bytes, size);               // bytes have arrived
//   size = session.NextAnswers(buffer);      // while nothing is being sent
//   if (size == 0) size = session.NextEvents(buffer);
//
// Answers come before packets of streams.  All answers are sent in the order of their requests.
//
// Packets of streams are sent when the client has sent something since the last ones, usually an
// EVENT packet, which has no answer.  Because then nothing is under way to the client, neither a
// slow client nor Nagle's algorithm delays the answers behind them.  A client that sends nothing
// gets packets every EVENT_FRAMES.
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
    // Size of the buffer for NextAnswers() and NextEvents(), in bytes.  The bytes to send are at
    // most the first RC_MAX_PACKET; an answer that has no room there waits behind them.
    static const int SEND_SIZE = 2 * RC_MAX_PACKET;

    ClientSession() : handler_(0), number_(0) { Reset(); }

    // Begins a session of client `number`, a place in `handler`.
    void Begin(int number, RequestHandler* handler);

    // Ends the client's upload and subscriptions.
    void End() { handler_->EndClient(number_); }

    // Appends received bytes.  REQUIRES: size <= RC_MAX_PACKET, and NextAnswers() has returned 0
    // since the last call.
    void Take(const Uint8* bytes, int size);

    // Answers requests that have arrived completely, as many as one send has room for.  Writes the
    // answers to `buffer`, always the same one, and returns their size; 0: more bytes are needed.
    int NextAnswers(Uint8* buffer);

    // Writes the due packets of streams to `buffer` and returns their size; 0: none is due.
    // REQUIRES: NextAnswers() has just returned 0.
    int NextEvents(Uint8* buffer);

    // Writes to `buffer` that the client gets no place, and returns the size.  The session ends
    // after that.  Used when the client has sent no request.
    int TurnAway(Uint8* buffer) { return TurnAway(buffer, 0); }

    // Returns whether the connection ends when the last bytes were sent.
    bool IsLast() const { return isLast_ && heldSize_ == 0; }
    void SetLast() { isLast_ = true; }

    // Returns whether a request has asked for the end of the run.
    bool EndsRun() const { return endsRun_; }

    // Clients that have no place get an answer to their first request that says so.
    bool IsWaiting() const { return isWaiting_; }
    void SetWaiting(bool waiting) { isWaiting_ = waiting; }

    // Returns why the bytes of the client are no packet; "" when they are.
    const std::string& Error() const { return framer_.Error(); }

private:
    // Time between packets of streams to a client that sends nothing, in frames of 8 ms: 224 ms.
    // After 200 ms the client's side has acknowledged what was sent before (network.md 4.3).
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
    bool hasSpoken_;     // whether the client has sent something since the last packet of a stream
    Uint32 eventFrame_;  // frame of that packet
    int heldAt_;         // place in the buffer of an answer that had no room in the last send
    int heldSize_;       // its size; 0: there is none
};

#endif  // ClientSession_h_DEFINED
