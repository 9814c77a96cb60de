#include "BallEyes.h"

#include <OPENR/OFbkImage.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

static const char* const CAMERA = "PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1";
static const char* const NECK_TILT = "PRM:/r1/c1-Joint2:j1";
static const char* const NECK_PAN = "PRM:/r1/c1/c2-Joint2:j2";

// The colours of the field, for all luminances.  Cr is high for red and Cb for blue; 128 stands for
// a colour difference of 0.  The bounds are narrow, so that orange and pink do not overlap.
struct ColourTable {
    OCdtChannel channel;
    byte crMax;
    byte crMin;
    byte cbMax;
    byte cbMin;
};
static const ColourTable COLOURS[] = {{ORANGE, 255, 195, 70, 0},
                                      {SKY_BLUE, 95, 20, 255, 175},
                                      {PINK, 255, 185, 170, 105},
                                      {YELLOW, 180, 138, 70, 0}};
static const int NUM_COLOURS = sizeof(COLOURS) / sizeof(COLOURS[0]);

BallEyes::BallEyes()
    : camera_(oprimitiveID_UNDEF), tiltJoint_(oprimitiveID_UNDEF), panJoint_(oprimitiveID_UNDEF),
      tiltElement_(-1), panElement_(-1)
{
    for (int i = 0; i < NUM_FRAMES; i++) {
        frame_[i] = NO_FRAME;
        tilt_[i] = pan_[i] = 0;
    }
}

static OStatus
Open(const char* locator, OPrimitiveID* id)
{
    const OStatus status = OPENR::OpenPrimitive(locator, id);
    if (status != oSUCCESS) {
        OSYSLOG1((osyslogERROR, "BallEyes: cannot open %s, status %u", locator, (unsigned)status));
    }
    return status;
}

OStatus
BallEyes::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;

    if (Open(CAMERA, &camera_) != oSUCCESS) return oFAIL;
    if (Open(NECK_TILT, &tiltJoint_) != oSUCCESS) return oFAIL;
    if (Open(NECK_PAN, &panJoint_) != oSUCCESS) return oFAIL;
    return SetColourTables();
}

OStatus
BallEyes::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
BallEyes::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
BallEyes::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

OStatus
BallEyes::SetColourTables()
{
    MemoryRegionID id;
    OCdtVectorData* tables;
    OStatus status = OPENR::NewCdtVectorData(&id, &tables);
    if (status != oSUCCESS) return status;
    tables->SetNumData(NUM_COLOURS);
    for (int i = 0; i < NUM_COLOURS; i++) {
        const ColourTable& colour = COLOURS[i];
        OCdtInfo* info = tables->GetInfo(i);
        info->Init(camera_, colour.channel);
        for (int y = 0; y < (int)ocdtMAX_Y_SEGMENT; y++) {
            info->Set(y, colour.crMax, colour.crMin, colour.cbMax, colour.cbMin);
        }
    }
    status = OPENR::SetCdtVectorData(id);
    OPENR::DeleteCdtVectorData(id);
    return status;
}

// Keeps the angles of the neck.
void
BallEyes::NotifySensor(const ONotifyEvent& event)
{
    OSensorFrameVectorData* vector = (OSensorFrameVectorData*)event.Data(0);
    if (tiltElement_ < 0 || panElement_ < 0) FindElements(vector);
    if (tiltElement_ < 0 || panElement_ < 0) return;  // DoInit has said which joint is missing
    const OSensorFrameInfo* info = vector->GetInfo(tiltElement_);
    for (int f = 0; f < (int)info->numFrames; f++) {
        const int i = (info->frameNumber + f) % NUM_FRAMES;
        frame_[i] = info->frameNumber + f;
        tilt_[i] = vector->GetData(tiltElement_)->frame[f].value / 1000000.0;
        pan_[i] = vector->GetData(panElement_)->frame[f].value / 1000000.0;
    }
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

// Finds the elements of the neck, which stay the same from vector to vector.
void
BallEyes::FindElements(OSensorFrameVectorData* vector)
{
    const int numElements = (int)vector->vectorInfo.numData;
    for (int e = 0; e < numElements; e++) {
        if (vector->GetInfo(e)->primitiveID == tiltJoint_) tiltElement_ = e;
        if (vector->GetInfo(e)->primitiveID == panJoint_) panElement_ = e;
    }
}

void
BallEyes::NotifyImage(const ONotifyEvent& event)
{
    OFbkImageVectorData* vector = (OFbkImageVectorData*)event.Data(0);
    OFbkImageInfo* info = vector->GetInfo(ofbkimageLAYER_C);
    OFbkImage image(info, vector->GetData(ofbkimageLAYER_C), ofbkimageBAND_CDT);
    const int i = info->frameNumber % NUM_FRAMES;
    // Without the angles of this frame, nobody can tell where the things in the picture are.
    if (image.IsValid() && frame_[i] == info->frameNumber) {
        const Sight sight =
            eyes_.See(image.Pointer(), image.Width(), image.Height(), tilt_[i], pan_[i]);
        subject[sbjSight]->SetData(&sight, sizeof(sight));
        subject[sbjSight]->NotifyObservers();
    }
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}
