#include "Tone.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include <math.h>

static const char* const LOCATOR = "PRM:/r1/c1/c2/c3/s1-Speaker:S1";

Tone::Tone() : speaker_(oprimitiveID_UNDEF), numSent_(0), isDone_(true)
{
    for (int i = 0; i < NUM_REGIONS; i++) region_[i] = 0;
}

OStatus
Tone::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;

    const OStatus status = OPENR::OpenPrimitive(LOCATOR, &speaker_);
    if (status != oSUCCESS) {
        OSYSLOG1((osyslogERROR, "Tone: cannot open %s, status %u", LOCATOR, (unsigned)status));
        return oFAIL;
    }
    if (NewRegions() != oSUCCESS) return oFAIL;
    return SetUpSpeaker();
}

OStatus
Tone::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Tone::DoStop(const OSystemEvent&)
{
    isDone_ = true;
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Tone::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// Mutes the speaker while the motors' power, which is also the amplifier's, is switched on, so that
// the speaker does not crack.  The volume is -10 dB, the largest for which the robot's circuit is
// made.
OStatus
Tone::SetUpSpeaker()
{
    OPENR::ControlPrimitive(speaker_, oprmreqSPEAKER_MUTE_ON, 0, 0, 0, 0);
    OPENR::SetMotorPower(opowerON);
    OPENR::ControlPrimitive(speaker_, oprmreqSPEAKER_MUTE_OFF, 0, 0, 0, 0);

    OPrimitiveControl_SpeakerVolume volume(ospkvol10dB);
    OPENR::ControlPrimitive(speaker_, oprmreqSPEAKER_SET_VOLUME, &volume, sizeof(volume), 0, 0);

    OPrimitiveControl_SpeakerSoundType type(ospksndMONO16K16B);
    const OStatus status = OPENR::ControlPrimitive(speaker_, oprmreqSPEAKER_SET_SOUND_TYPE, &type,
                                                   sizeof(type), 0, 0);
    if (status != oSUCCESS) {
        OSYSLOG1((osyslogERROR, "Tone: no 16 kHz sound, status %u", (unsigned)status));
        return oFAIL;
    }
    isDone_ = false;
    return oSUCCESS;
}

OStatus
Tone::NewRegions()
{
    for (int i = 0; i < NUM_REGIONS; i++) {
        MemoryRegionID id;
        OSoundVectorData* vector;
        const OStatus status = OPENR::NewSoundVectorData(1, SAMPLES_PER_VECTOR * sizeof(sword),
                                                         &id, &vector);
        if (status != oSUCCESS) return status;
        vector->SetNumData(1);
        vector->GetInfo(0)->Set(odataSOUND, speaker_, SAMPLES_PER_VECTOR * sizeof(sword));
        region_[i] = new RCRegion(vector->vectorInfo.memRegionID, vector->vectorInfo.offset,
                                  (void*)vector, vector->vectorInfo.totalSize);
    }
    return oSUCCESS;
}

RCRegion*
Tone::FindFreeRegion()
{
    for (int i = 0; i < NUM_REGIONS; i++) {
        if (region_[i]->NumberOfReference() == 1) return region_[i];
    }
    return 0;
}

// Sends the next vector.  Called first when the speaker is ready for vectors, then once for every
// vector that was played.
void
Tone::ReadySpeaker(const OReadyEvent& event)
{
    if (!event.IsAssert() || isDone_) return;
    if (numSent_ == 0) OSYSPRINT(("Tone: %d Hz for %d ms\n", HERTZ,
                                  NUM_SAMPLES / (SAMPLES_PER_SECOND / 1000)));
    int numSet = 0;
    for (RCRegion* region = FindFreeRegion(); region != 0; region = FindFreeRegion()) {
        if (numSent_ >= NUM_SAMPLES) break;
        FillNextVector((OSoundVectorData*)region->Base());
        subject[sbjSpeaker]->SetData(region);
        numSet++;
    }
    if (numSet > 0) {
        subject[sbjSpeaker]->NotifyObservers();
    } else if (region_[0]->NumberOfReference() == 1 && region_[1]->NumberOfReference() == 1) {
        OSYSPRINT(("Tone: played\n"));
        isDone_ = true;
    }
}

// Fills a vector with the next samples, and the rest of the last vector with silence.
void
Tone::FillNextVector(OSoundVectorData* vector)
{
    sword* sample = (sword*)vector->GetData(0);
    for (int i = 0; i < SAMPLES_PER_VECTOR; i++) {
        sample[i] = numSent_ + i < NUM_SAMPLES ? Sample(numSent_ + i) : 0;
    }
    numSent_ += SAMPLES_PER_VECTOR;
}

// Returns a sample of the tone.  500 Hz fit 32 times into 16 kHz, so the tone ends with the value
// with which it began, zero.
sword
Tone::Sample(int number) const
{
    const int period = SAMPLES_PER_SECOND / HERTZ;
    return (sword)(AMPLITUDE * sin(2 * M_PI * (number % period) / period));
}
