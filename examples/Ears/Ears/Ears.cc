#include "Ears.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

static const char* const LOCATORS[] = {
    "PRM:/r1/c1/c2/c3/e1-Joint3:j5",  // left ear
    "PRM:/r1/c1/c2/c3/e2-Joint3:j6"   // right
};
static const char* const NAMES[] = {"left", "right"};

Ears::Ears() : region_(0), numSent_(0)
{
    for (int i = 0; i < NUM_EARS; i++) ear_[i] = oprimitiveID_UNDEF;
}

OStatus
Ears::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;

    if (OpenEars() != oSUCCESS || NewRegion() != oSUCCESS) return oFAIL;
    OPENR::SetMotorPower(opowerON);
    return oSUCCESS;
}

OStatus
Ears::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Ears::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Ears::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// Opens both ears.  On an ERS-220, which has no ears, this fails with oNOT_FOUND.
OStatus
Ears::OpenEars()
{
    for (int i = 0; i < NUM_EARS; i++) {
        const OStatus status = OPENR::OpenPrimitive(LOCATORS[i], &ear_[i]);
        if (status == oSUCCESS) continue;
        OSYSLOG1((osyslogERROR, "Ears: cannot open %s, status %u", LOCATORS[i], (unsigned)status));
        return status;
    }
    return oSUCCESS;
}

OStatus
Ears::NewRegion()
{
    MemoryRegionID id;
    OCommandVectorData* vector;
    const OStatus status = OPENR::NewCommandVectorData(NUM_EARS, &id, &vector);
    if (status != oSUCCESS) return status;
    vector->SetNumData(NUM_EARS);
    region_ = new RCRegion(vector->vectorInfo.memRegionID, vector->vectorInfo.offset,
                           (void*)vector, vector->vectorInfo.totalSize);
    return oSUCCESS;
}

// Uses the only region again: at this ready the region is free.  One region is enough, because the
// next command is not urgent.
void
Ears::ReadyEar(const OReadyEvent& event)
{
    if (!event.IsAssert() || region_ == 0 || numSent_ > NUM_FLICKS) return;
    if (region_->NumberOfReference() != 1) return;
    if (numSent_ == NUM_FLICKS) {
        Rest();
    } else {
        Flick(numSent_ % NUM_EARS);
    }
    numSent_++;
    subject[sbjEar]->SetData(region_);
    subject[sbjEar]->NotifyObservers();
}

// Sends a vector with one frame, because the plunger that moves an ear must not stay under power
// for long.
void
Ears::Flick(int ear)
{
    OSYSPRINT(("Ears: %s\n", NAMES[ear]));
    OCommandVectorData* vector = (OCommandVectorData*)region_->Base();
    for (int i = 0; i < NUM_EARS; i++) {
        vector->GetInfo(i)->Set(odataJOINT_COMMAND3, ear_[i], 1);
        OJointCommandValue3* value = (OJointCommandValue3*)vector->GetData(i)->value;
        value->value = i == ear ? ojoint3_STATE1 : ojoint3_STATE0;
        value->reserved = 0;
        value->padding = 0;
    }
}

void
Ears::Rest()
{
    OSYSPRINT(("Ears: at rest\n"));
    OCommandVectorData* vector = (OCommandVectorData*)region_->Base();
    for (int i = 0; i < NUM_EARS; i++) {
        OJointCommandValue3* value = (OJointCommandValue3*)vector->GetData(i)->value;
        value->value = ojoint3_STATE0;
    }
}
