//
// ClientStreams: the subscriptions of one client.  It knows which streams the client wants, and
// whether a packet of a stream is due.
//
// A packet of a stream has the newest values at the time when it is sent.  A client that receives
// slowly gets fewer packets, so a stream needs no memory for old values.
//

#ifndef ClientStreams_h_DEFINED
#define ClientStreams_h_DEFINED

#include "RemoteStreams.h"

class ClientStreams {
public:
    ClientStreams() { Clear(); }

    // Ends all subscriptions of the client.
    void Clear();

    // Begins or replaces the subscription of a stream.  `period` is the smallest number of frames
    // between two packets.  `tag` is the tag of the packets.
    void Begin(int stream, Uint16 period, Uint16 tag);
    void End(int stream) { stream_[stream].isOn = false; }

    // Counts new values of a stream.  Has no effect without a subscription.  `frame` is the frame
    // number of the newest sensor values.
    void NewValues(int stream, Uint32 frame);

    // Returns the stream with a packet that is due in `frame`; -1 if no packet is due.
    int Due(Uint32 frame) const;

    // Records that a packet of `stream` is made in `frame`.  Returns the number of values that the
    // client did not get since the packet before.
    Uint16 Sent(int stream, Uint32 frame);

    Uint16 Tag(int stream) const { return stream_[stream].tag; }

private:
    struct Stream {
        bool isOn;
        Uint16 tag;
        Uint16 period;
        bool hasLastFrame;  // whether lastFrame was set since Begin()
        Uint32 lastFrame;   // frame in which a packet was last sent or, for sensor values, last due
        Uint16 numNew;      // number of values that NewValues() has counted since the newest packet
    };

    bool IsPeriodOver(const Stream& stream, Uint32 frame) const;

    Stream stream_[NUM_RC_STREAMS];
};

#endif  // ClientStreams_h_DEFINED
