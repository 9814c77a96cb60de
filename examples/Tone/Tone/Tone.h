//
// Tone plays a tone of 500 Hz for a second.
//
//   Tone.Speaker -> OVirtualRobotAudioComm.Speaker
//
// The sound has 16 kHz, 16 bits, mono: 1024 bytes are 32 ms.  The object keeps two vectors in the
// speaker: while one plays, the other waits.
//

#ifndef Tone_h_DEFINED
#define Tone_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <OPENR/ODataFormats.h>

#include "def.h"

class Tone : public OObject {
public:
    Tone();
    virtual ~Tone() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadySpeaker(const OReadyEvent& event);

private:
    static const int NUM_REGIONS = 2;
    static const int SAMPLES_PER_SECOND = 16000;
    static const int SAMPLES_PER_VECTOR = 512;
    static const int HERTZ = 500;
    static const int NUM_SAMPLES = SAMPLES_PER_SECOND;  // the tone lasts a second
    static const int AMPLITUDE = 8000;                  // the largest sample would be 32767

    OStatus SetUpSpeaker();
    OStatus NewRegions();
    RCRegion* FindFreeRegion();
    void FillNextVector(OSoundVectorData* vector);
    sword Sample(int number) const;

    OPrimitiveID speaker_;
    RCRegion* region_[NUM_REGIONS];
    int numSent_;  // number of samples sent
    bool isDone_;  // also true until DoInit has succeeded, because readies come even when it has
                   // failed
};

#endif  // Tone_h_DEFINED
