#include "Walker.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/OUnits.h>
#include <OPENR/core_macro.h>

static const char* const AXES[] = {
    "PRM:/a1-Sensor:a1",  // front positive
    "PRM:/a2-Sensor:a2",  // right positive
    "PRM:/a3-Sensor:a3"   // up positive
};

Walker::Walker() : state_(OFF)
{
    for (int j = 0; j < NUM_JOINTS; j++) joint_[j] = oprimitiveID_UNDEF;
    for (int a = 0; a < NUM_AXES; a++) {
        axis_[a] = oprimitiveID_UNDEF;
        axisElement_[a] = -1;
    }
    for (int i = 0; i < NUM_REGIONS; i++) region_[i] = 0;
}

OStatus
Walker::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;

    if (OpenPrimitives() != oSUCCESS || NewRegions() != oSUCCESS) return oFAIL;
    OPENR::SetMotorPower(opowerON);
    state_ = IDLE;
    return oSUCCESS;
}

OStatus
Walker::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Walker::DoStop(const OSystemEvent&)
{
    state_ = OFF;
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Walker::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

static OStatus
Open(const char* locator, OPrimitiveID* id)
{
    const OStatus status = OPENR::OpenPrimitive(locator, id);
    if (status != oSUCCESS) {
        OSYSLOG1((osyslogERROR, "Walker: cannot open %s, status %u", locator, (unsigned)status));
    }
    return status;
}

OStatus
Walker::OpenPrimitives()
{
    for (int j = 0; j < NUM_JOINTS; j++) {
        if (Open(JOINTS[j].locator, &joint_[j]) != oSUCCESS) return oFAIL;
    }
    for (int a = 0; a < NUM_AXES; a++) {
        if (Open(AXES[a], &axis_[a]) != oSUCCESS) return oFAIL;
    }
    return oSUCCESS;
}

OStatus
Walker::NewRegions()
{
    for (int i = 0; i < NUM_REGIONS; i++) {
        MemoryRegionID id;
        OCommandVectorData* vector;
        const OStatus status = OPENR::NewCommandVectorData(NUM_JOINTS, &id, &vector);
        if (status != oSUCCESS) return status;
        vector->SetNumData(NUM_JOINTS);
        for (int j = 0; j < NUM_JOINTS; j++) {
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
Walker::FindFreeRegion()
{
    for (int i = 0; i < NUM_REGIONS; i++) {
        if (region_[i]->NumberOfReference() == 1) return region_[i];
    }
    return 0;
}

// Continues the motion.  Called first when the Effector is ready for vectors, then once for every
// vector that has ended.
void
Walker::ReadyMove(const OReadyEvent& event)
{
    if (!event.IsAssert()) return;
    switch (state_) {
    case IDLE:
        HoldStill();
        state_ = HOLDING;
        break;
    case HOLDING:
        EnableGains();
        state_ = MOVING;
        SendVectors();
        break;
    case MOVING:
        SendVectors();
        break;
    case OFF:
        break;
    }
}

// Sends set points at the present angles.  With enabled gains and other set points the dog would
// jump.
void
Walker::HoldStill()
{
    RCRegion* region = FindFreeRegion();
    OCommandVectorData* vector = (OCommandVectorData*)region->Base();
    double now[NUM_JOINTS];
    for (int j = 0; j < NUM_JOINTS; j++) {
        OJointValue joint;
        OPENR::GetJointValue(joint_[j], &joint);
        now[j] = joint.value / 1000000.0;
        OJointCommandValue2* value = (OJointCommandValue2*)vector->GetData(j)->value;
        for (int f = 0; f < NUM_FRAMES; f++) {
            value[f].value = joint.value;
            value[f].padding = 0;
        }
    }
    motion_.Begin(now);
    subject[sbjMove]->SetData(region);
    subject[sbjMove]->NotifyObservers();
}

void
Walker::EnableGains()
{
    for (int j = 0; j < NUM_JOINTS; j++) {
        const word* gain = JOINTS[j].gain;
        OPENR::EnableJointGain(joint_[j]);
        OPENR::SetJointGain(joint_[j], gain[0], gain[1], gain[2], 0x0e, 0x02, 0x0f);
    }
}

// Fills all free regions, two at first and then one each time, and sends them with one notify: a
// second notify before the next ready would replace the first.  Without data, NotifyObservers()
// does nothing.
void
Walker::SendVectors()
{
    RCRegion* region;
    while ((region = FindFreeRegion()) != 0) {
        FillVector((OCommandVectorData*)region->Base());
        subject[sbjMove]->SetData(region);
    }
    subject[sbjMove]->NotifyObservers();
}

void
Walker::FillVector(OCommandVectorData* vector)
{
    double angle[NUM_JOINTS];
    for (int f = 0; f < NUM_FRAMES; f++) {
        motion_.Step(angle);
        for (int j = 0; j < NUM_JOINTS; j++) {
            OJointCommandValue2* value = (OJointCommandValue2*)vector->GetData(j)->value;
            value[f].value = micro(angle[j]);
            value[f].padding = 0;
        }
    }
}

// Passes the newest accelerations on, which tell whether the dog has fallen over.
void
Walker::NotifySensor(const ONotifyEvent& event)
{
    OSensorFrameVectorData* vector = (OSensorFrameVectorData*)event.Data(0);
    if (axisElement_[0] < 0) FindAxes(vector);
    double acceleration[NUM_AXES];
    for (int a = 0; a < NUM_AXES; a++) {
        if (axisElement_[a] < 0) return;  // DoInit has said which sensor is missing
        const int last = (int)vector->GetInfo(axisElement_[a])->numFrames - 1;
        acceleration[a] = vector->GetData(axisElement_[a])->frame[last].value / 1000000.0;
    }
    motion_.Feel(acceleration[0], acceleration[1], acceleration[2]);
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

// Finds the elements of the acceleration sensors, which stay the same from vector to vector.
void
Walker::FindAxes(OSensorFrameVectorData* vector)
{
    const int numElements = (int)vector->vectorInfo.numData;
    for (int a = 0; a < NUM_AXES; a++) {
        for (int e = 0; e < numElements; e++) {
            if (vector->GetInfo(e)->primitiveID == axis_[a]) axisElement_[a] = e;
        }
    }
}

void
Walker::NotifyCommand(const ONotifyEvent& event)
{
    motion_.SetCommand(*(const WalkCommand*)event.Data(0));
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}
