#include "StandUp.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/OUnits.h>
#include <OPENR/core_macro.h>

StandUp::StandUp() : state_(DONE), posture_(0), vector_(0)
{
    for (int j = 0; j < NUM_LEG_JOINTS; j++) joint_[j] = oprimitiveID_UNDEF;
    for (int j = 0; j < NUM_LEG_JOINTS; j++) from_[j] = 0;
    for (int i = 0; i < NUM_REGIONS; i++) region_[i] = 0;
}

OStatus
StandUp::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;

    if (OpenJoints() != oSUCCESS || NewRegions() != oSUCCESS) return oFAIL;
    OPENR::SetMotorPower(opowerON);
    state_ = IDLE;
    return oSUCCESS;
}

OStatus
StandUp::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
StandUp::DoStop(const OSystemEvent&)
{
    state_ = DONE;
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
StandUp::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

OStatus
StandUp::OpenJoints()
{
    for (int j = 0; j < NUM_LEG_JOINTS; j++) {
        const OStatus status = OPENR::OpenPrimitive(LEG_JOINTS[j].locator, &joint_[j]);
        if (status == oSUCCESS) continue;
        OSYSLOG1((osyslogERROR, "StandUp: cannot open %s, status %u", LEG_JOINTS[j].locator,
                  (unsigned)status));
        return status;
    }
    return oSUCCESS;
}

OStatus
StandUp::NewRegions()
{
    for (int i = 0; i < NUM_REGIONS; i++) {
        MemoryRegionID id;
        OCommandVectorData* vector;
        const OStatus status = OPENR::NewCommandVectorData(NUM_LEG_JOINTS, &id, &vector);
        if (status != oSUCCESS) return status;
        vector->SetNumData(NUM_LEG_JOINTS);
        for (int j = 0; j < NUM_LEG_JOINTS; j++) {
            vector->GetInfo(j)->Set(odataJOINT_COMMAND2, joint_[j], NUM_FRAMES);
        }
        region_[i] = new RCRegion(vector->vectorInfo.memRegionID, vector->vectorInfo.offset,
                                  (void*)vector, vector->vectorInfo.totalSize);
    }
    return oSUCCESS;
}

// Returns a region that only this object refers to.  While there is a second reference, the
// Effector still uses the region.
RCRegion*
StandUp::FindFreeRegion()
{
    for (int i = 0; i < NUM_REGIONS; i++) {
        if (region_[i]->NumberOfReference() == 1) return region_[i];
    }
    return 0;
}

// Continues the movement.  Called first when the Effector is ready for vectors, then once for every
// vector that has ended.
void
StandUp::ReadyMove(const OReadyEvent& event)
{
    if (!event.IsAssert()) return;
    switch (state_) {
    case IDLE:
        HoldStill();
        state_ = HOLDING;
        break;
    case HOLDING:
        EnableGains();
        BeginPosture();
        state_ = MOVING;
        SendVectors();
        break;
    case MOVING:
        SendVectors();
        break;
    case DONE:
        break;  // sends nothing, so no further ready comes; the last set points stay in force
    }
}

// Sends set points at the present angles of the legs.  With enabled gains and other set points the
// dog would jump.
void
StandUp::HoldStill()
{
    OSYSPRINT(("StandUp: holding still\n"));
    RCRegion* region = FindFreeRegion();
    OCommandVectorData* vector = (OCommandVectorData*)region->Base();
    for (int j = 0; j < NUM_LEG_JOINTS; j++) {
        OJointValue now;
        OPENR::GetJointValue(joint_[j], &now);
        from_[j] = degrees(now.value / 1000000.0);
        OJointCommandValue2* value = (OJointCommandValue2*)vector->GetData(j)->value;
        for (int f = 0; f < NUM_FRAMES; f++) {
            value[f].value = now.value;
            value[f].padding = 0;
        }
    }
    subject[sbjMove]->SetData(region);
    subject[sbjMove]->NotifyObservers();
}

void
StandUp::EnableGains()
{
    OSYSPRINT(("StandUp: gains on\n"));
    for (int j = 0; j < NUM_LEG_JOINTS; j++) {
        const word* gain = LEG_JOINTS[j].gain;
        OPENR::EnableJointGain(joint_[j]);
        OPENR::SetJointGain(joint_[j], gain[0], gain[1], gain[2], 0x0e, 0x02, 0x0f);
    }
}

// Fills all free regions, two at first and then one each time, and sends them with one notify: a
// second notify before the next ready would replace the first.
void
StandUp::SendVectors()
{
    int numSet = 0;
    for (RCRegion* region = FindFreeRegion(); region != 0; region = FindFreeRegion()) {
        if (posture_ == NUM_POSTURES) break;
        FillNextVector((OCommandVectorData*)region->Base());
        subject[sbjMove]->SetData(region);
        numSet++;
    }
    if (numSet > 0) {
        subject[sbjMove]->NotifyObservers();
    } else if (region_[0]->NumberOfReference() == 1 && region_[1]->NumberOfReference() == 1) {
        OSYSPRINT(("StandUp: done\n"));
        state_ = DONE;
    }
}

void
StandUp::BeginPosture()
{
    vector_ = 0;
    OSYSPRINT(("StandUp: to %s\n", POSTURES[posture_].name));
}

// Fills a vector with the next part of the way between two postures.  The way is a smooth curve,
// slow at both ends, so that the legs do not jerk.
void
StandUp::FillNextVector(OCommandVectorData* vector)
{
    const Posture& to = POSTURES[posture_];
    const int numAll = to.numVectors * NUM_FRAMES;
    for (int f = 0; f < NUM_FRAMES; f++) {
        const double t = (double)(vector_ * NUM_FRAMES + f + 1) / numAll;
        const double part = t * t * (3 - 2 * t);
        for (int j = 0; j < NUM_LEG_JOINTS; j++) {
            OJointCommandValue2* value = (OJointCommandValue2*)vector->GetData(j)->value;
            value[f].value = oradians(from_[j] + (to.degrees[j] - from_[j]) * part);
            value[f].padding = 0;
        }
    }
    if (++vector_ < to.numVectors) return;
    for (int j = 0; j < NUM_LEG_JOINTS; j++) from_[j] = to.degrees[j];
    if (++posture_ < NUM_POSTURES) BeginPosture();
}
