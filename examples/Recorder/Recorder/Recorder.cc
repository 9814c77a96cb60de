#include "Recorder.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include <stdio.h>
#include <string.h>

#include "WavHeader.h"

static const char* const LOCATOR = "PRM:/r1/c1/c2/c3/m1-Mic:M1";
static const char* const FILE_NAME = "/MS/OPEN-R/MW/DATA/P/RECORD.WAV";

Recorder::Recorder() : mic_(oprimitiveID_UNDEF), data_(0), numBytes_(0) {}

OStatus
Recorder::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;

    const OStatus status = OPENR::OpenPrimitive(LOCATOR, &mic_);
    if (status != oSUCCESS) {
        OSYSLOG1((osyslogERROR, "Recorder: cannot open %s, status %u", LOCATOR,
                  (unsigned)status));
        return oFAIL;
    }
    data_ = new byte[NUM_BYTES];
    return oSUCCESS;
}

OStatus
Recorder::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    OSYSPRINT(("Recorder: listening\n"));
    return oSUCCESS;
}

OStatus
Recorder::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Recorder::DoDestroy(const OSystemEvent&)
{
    delete[] data_;
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// Copies the sound, and writes the file only when all sound was recorded: writing to the stick
// while sound comes in would lose some of it.
void
Recorder::NotifyMic(const ONotifyEvent& event)
{
    if (data_ == 0) return;  // DoInit has failed
    OSoundVectorData* vector = (OSoundVectorData*)event.Data(0);
    int size = (int)vector->GetInfo(0)->dataSize;
    if (size > NUM_BYTES - numBytes_) size = NUM_BYTES - numBytes_;
    memcpy(data_ + numBytes_, vector->GetData(0), size);
    numBytes_ += size;
    if (numBytes_ < NUM_BYTES) {
        observer[event.ObsIndex()]->AssertReady(event.SenderID());
        return;
    }
    // Asserts no further ready, because the recording is over.
    if (WriteFile()) OSYSPRINT(("Recorder: wrote %s, %d bytes\n", FILE_NAME,
                                WAV_HEADER_SIZE + numBytes_));
}

bool
Recorder::WriteFile() const
{
    byte header[WAV_HEADER_SIZE];
    WriteWavHeader(header, 2, 16000, numBytes_);
    FILE* file = fopen(FILE_NAME, "wb");
    bool isGood = file != 0 && fwrite(header, 1, sizeof(header), file) == sizeof(header) &&
                  fwrite(data_, 1, numBytes_, file) == (size_t)numBytes_;
    if (file != 0 && fclose(file) != 0) isGood = false;
    if (!isGood) OSYSLOG1((osyslogERROR, "Recorder: cannot write %s", FILE_NAME));
    return isGood;
}
