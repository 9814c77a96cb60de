#include "BallEyes.h"

#include <OPENR/OFbkImage.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include "Maths.h"

static const char* const CAMERA = "PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1";
static const char* const NECK_TILT = "PRM:/r1/c1-Joint2:j1";
static const char* const NECK_PAN = "PRM:/r1/c1/c2-Joint2:j2";

// The colours of the field, for all luminances.  128 stands for a colour difference of 0.
struct Colour {
    OCdtChannel channel;
    byte crMax;
    byte crMin;
    byte cbMax;
    byte cbMin;
};
static const Colour ORANGE = {ocdtCHANNEL0, 255, 195, 70, 0};
static const Colour SKY_BLUE = {ocdtCHANNEL1, 95, 20, 255, 175};
static const Colour PINK = {ocdtCHANNEL2, 255, 185, 170, 105};
static const Colour YELLOW = {ocdtCHANNEL3, 180, 138, 70, 0};

static const double BALL_RADIUS = 43;  // mm
static const int FEWEST_BALL_PIXELS = 3;
static const int FEWEST_GOAL_COLUMNS = 12;

BallEyes::BallEyes()
    : camera_(oprimitiveID_UNDEF), tiltJoint_(oprimitiveID_UNDEF), panJoint_(oprimitiveID_UNDEF),
      tiltElement_(-1), panElement_(-1), width_(0), height_(0)
{
    for (int f = 0; f < NUM_FRAMES; f++) tilt_[f] = pan_[f] = 0;
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
    const Colour colours[] = {ORANGE, SKY_BLUE, PINK, YELLOW};
    const int numColours = sizeof(colours) / sizeof(colours[0]);
    MemoryRegionID id;
    OCdtVectorData* tables;
    OStatus status = OPENR::NewCdtVectorData(&id, &tables);
    if (status != oSUCCESS) return status;
    tables->SetNumData(numColours);
    for (int i = 0; i < numColours; i++) {
        const Colour& colour = colours[i];
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
    if (tiltElement_ < 0) FindElements(vector);
    const OSensorFrameInfo* info = vector->GetInfo(tiltElement_);
    for (int f = 0; f < (int)info->numFrames; f++) {
        const int i = (info->frameNumber + f) % NUM_FRAMES;
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
    width_ = image.Width();
    height_ = image.Height();
    const int frame = info->frameNumber % NUM_FRAMES;
    const Look look(tilt_[frame], pan_[frame], width_, height_);

    LookForBall(image.Pointer(), look);
    LookForGoal(SKY_BLUE_GOAL, image.Pointer(), look);
    LookForGoal(YELLOW_GOAL, image.Pointer(), look);
    subject[sbjSight]->SetData(&sight_, sizeof(sight_));
    subject[sbjSight]->NotifyObservers();
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

void
BallEyes::LookForBall(const byte* pixels, const Look& look)
{
    BallSight& ball = sight_.ball;
    const Blob blob = finder_.FindLargest(pixels, width_, height_, ORANGE.channel);
    ball.isSeen = blob.numPixels >= FEWEST_BALL_PIXELS &&
                  look.FindPlace(look.RayOf(blob.x, blob.y), BALL_RADIUS, &ball.x, &ball.y);
}

// Returns whether the blob is part of a beacon: there is pink right above or below it.
bool
BallEyes::IsOnBeacon(const Blob& blob, const byte* pixels) const
{
    const int x = (int)blob.x;
    int numPink = 0;
    for (int d = 1; d <= 3; d++) {
        const int above = blob.top - d;
        const int below = blob.bottom + d;
        if (above >= 0 && (pixels[above * width_ + x] & PINK.channel)) numPink++;
        if (below < height_ - 1 && (pixels[below * width_ + x] & PINK.channel)) numPink++;
    }
    return numPink >= 2;
}

// Looks for the ends of a goal.  Two beacons have its colour, too, but they are narrow or have
// pink beside it.  While a beacon is the largest blob of the colour, no goal is seen.
void
BallEyes::LookForGoal(Goal goal, const byte* pixels, const Look& look)
{
    GoalSight& sight = sight_.goal[goal];
    const OCdtChannel channel = goal == SKY_BLUE_GOAL ? SKY_BLUE.channel : YELLOW.channel;
    const Blob blob = finder_.FindLargest(pixels, width_, height_, channel);
    sight.isSeen = blob.right - blob.left + 1 >= FEWEST_GOAL_COLUMNS && !IsOnBeacon(blob, pixels);
    if (!sight.isSeen) return;
    const Ray left = look.RayOf(blob.left, blob.y);
    const Ray right = look.RayOf(blob.right + 1, blob.y);
    sight.left = ArcTan2(left.y, left.x);
    sight.right = ArcTan2(right.y, right.x);
}
