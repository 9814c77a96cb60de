#include "BallFinder.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

static const char CAMERA[] = "PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1";

// The bounds of pink that ball programs use, for every luminance.
static OStatus
SetColourTable()
{
    OPrimitiveID camera;
    OStatus status = OPENR::OpenPrimitive(CAMERA, &camera);
    if (status != oSUCCESS) return status;
    MemoryRegionID id;
    OCdtVectorData* tables;
    status = OPENR::NewCdtVectorData(&id, &tables);
    if (status != oSUCCESS) return status;
    tables->SetNumData(1);
    OCdtInfo* pink = tables->GetInfo(0);
    pink->Init(camera, ocdtCHANNEL0);
    for (int segment = 0; segment < (int)ocdtMAX_Y_SEGMENT; segment++)
        pink->Set(segment, 230, 150, 190, 120);
    status = OPENR::SetCdtVectorData(id);
    OPENR::DeleteCdtVectorData(id);
    return status;
}

OStatus
BallFinder::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return SetColourTable();
}

OStatus
BallFinder::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
BallFinder::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
BallFinder::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
BallFinder::NotifyImage(const ONotifyEvent& event)
{
    OFbkImageVectorData* vector = (OFbkImageVectorData*)event.Data(0);
    OFbkImage image(vector->GetInfo(ofbkimageLAYER_C), vector->GetData(ofbkimageLAYER_C),
                    ofbkimageBAND_CDT);
    // Layer C has no skip, so one pointer runs over it; the last row has the tag.
    int count = 0, sumX = 0, sumY = 0;
    const byte* pixel = image.Pointer();
    for (int y = 0; y < image.Height() - 1; y++) {
        for (int x = 0; x < image.Width(); x++, pixel++) {
            if ((*pixel & ocdtCHANNEL0) == 0) continue;
            count++;
            sumX += x;
            sumY += y;
        }
    }
    if (count > 0) {
        OSYSPRINT(("field %d: %d pixels of the ball at %d, %d; frequency %d\n",
                   image.FieldCounter(), count, sumX / count, sumY / count,
                   image.ColorFrequency(ocdtCHANNEL0)));
    }
    observer[event.ObsIndex()]->AssertReady();
}
