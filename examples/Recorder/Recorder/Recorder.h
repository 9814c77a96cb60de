//
// Recorder writes one second of the microphones' sound to the Memory Stick, as a WAV file.
//
//   Recorder.Mic <- OVirtualRobotAudioComm.Mic
//
// The sound has 16 kHz, 16 bits, left and right channel: 2048 bytes every 32 ms.
//

#ifndef Recorder_h_DEFINED
#define Recorder_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <OPENR/ODataFormats.h>

#include "def.h"

class Recorder : public OObject {
public:
    Recorder();
    virtual ~Recorder() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyMic(const ONotifyEvent& event);

private:
    static const int BYTES_PER_VECTOR = 2048;
    static const int NUM_VECTORS = 32;  // number of vectors to record: 1024 ms
    static const int NUM_BYTES = NUM_VECTORS * BYTES_PER_VECTOR;

    bool WriteFile() const;

    OPrimitiveID mic_;
    byte* data_;  // NUM_BYTES bytes from the heap; too many for a member of the object
    int numBytes_;
};

#endif  // Recorder_h_DEFINED
