#include "RemoteProtocol.h"

#include "ByteOrder.h"

bool
RcAnswerHeader::Read(const RcFramer& packet)
{
    header = packet.Header();
    frame = 0;
    status = 0;
    if (header.size < RC_ANSWER_HEADER_SIZE) return false;
    frame = GetU32(packet.Payload());
    status = GetU16(packet.Payload() + 4);
    return true;
}

void
RcInfo::Write(RcWriter* out) const
{
    out->U8(numJoints);
    out->U8(numLeds);
    out->U8(numEars);
    out->U8(numBinary);
    out->U8(numOther);
    out->U8(numMisc);
    out->U8(state);
    out->U8(0);
    out->String(design);
    out->String(software);
    if (!hasFiles) return;
    out->U8(processor);
    out->U32(largestMotion);
    out->U32(largestImage);
}

bool
RcInfo::Read(RcReader* in)
{
    numJoints = in->U8();
    numLeds = in->U8();
    numEars = in->U8();
    numBinary = in->U8();
    numOther = in->U8();
    numMisc = in->U8();
    state = in->U8();
    in->U8();
    design = in->String();
    software = in->String();
    hasFiles = in->RestSize() > 0;
    processor = hasFiles ? in->U8() : 0;
    largestMotion = hasFiles ? in->U32() : 0;
    largestImage = hasFiles ? in->U32() : 0;
    return in->IsComplete();
}

// Writes `numbers` to a packet, one after the other.  Does not write their count; the caller writes
// it.
static void
WriteNumbers(RcWriter* out, const std::vector<Sint32>& numbers)
{
    for (size_t i = 0; i < numbers.size(); i++) out->S32(numbers[i]);
}

static void
ReadNumbers(RcReader* in, int count, std::vector<Sint32>* numbers)
{
    numbers->clear();
    for (int i = 0; i < count && !in->HasFailed(); i++) numbers->push_back(in->S32());
}

void
RcDescription::Write(RcWriter* out) const
{
    out->String(name);
    out->String(title);
    out->String(locator);
    out->U8((Uint32)values.size());
    WriteNumbers(out, values);
}

bool
RcDescription::Read(RcReader* in)
{
    name = in->String();
    title = in->String();
    locator = in->String();
    ReadNumbers(in, in->U8(), &values);
    return in->IsComplete();
}

void
RcJointState::Write(RcWriter* out) const
{
    out->S32(position);
    out->S32(speed);
    out->S32(acceleration);
}

bool
RcJointState::Read(RcReader* in)
{
    position = in->S32();
    speed = in->S32();
    acceleration = in->S32();
    return in->IsComplete();
}

void
RcGains::Write(RcWriter* out) const
{
    out->U8(isOn);
    out->U8(0);
    for (int i = 0; i < 3; i++) out->U16(gain[i]);
    for (int i = 0; i < 3; i++) out->U16(shift[i]);
}

bool
RcGains::Read(RcReader* in)
{
    isOn = in->U8();
    in->U8();
    for (int i = 0; i < 3; i++) gain[i] = in->U16();
    for (int i = 0; i < 3; i++) shift[i] = in->U16();
    return in->IsComplete();
}

void
RcPower::Write(RcWriter* out) const
{
    out->U32(robotStatus);
    out->U16(batteryStatus);
    out->U16(capacity);
    out->U16(fullCapacity);
    out->U16(voltage);
    out->S32(current);
    out->S32(temperature);
}

bool
RcPower::Read(RcReader* in)
{
    robotStatus = in->U32();
    batteryStatus = in->U16();
    capacity = in->U16();
    fullCapacity = in->U16();
    voltage = in->U16();
    current = in->S32();
    temperature = in->S32();
    return in->IsComplete();
}

void
RcSensors::Write(RcWriter* out) const
{
    const std::vector<Sint32>* const groups[5] = { &joints, &binary, &other, &misc, &keyFrame };
    for (int i = 0; i < 5; i++) out->U8((Uint32)groups[i]->size());
    out->U8(state);
    out->U16(0);
    for (int i = 0; i < 5; i++) WriteNumbers(out, *groups[i]);
}

bool
RcSensors::Read(RcReader* in)
{
    std::vector<Sint32>* const groups[5] = { &joints, &binary, &other, &misc, &keyFrame };
    int counts[5];
    for (int i = 0; i < 5; i++) counts[i] = in->U8();
    state = in->U8();
    in->U16();
    for (int i = 0; i < 5; i++) ReadNumbers(in, counts[i], groups[i]);
    return in->IsComplete();
}

void
RcPlayRequest::Write(RcWriter* out) const
{
    out->String(file);
    out->U16(loops);
    out->U8(keyFramesPerVector);
}

bool
RcPlayRequest::Read(RcReader* in)
{
    file = in->String();
    loops = in->U16();
    keyFramesPerVector = in->U8();
    return in->IsComplete();
}

void
RcPlayAnswer::Write(RcWriter* out) const
{
    out->U32(durationMs);
    out->U16(keyFrames);
    out->U16(loops);
}

bool
RcPlayAnswer::Read(RcReader* in)
{
    durationMs = in->U32();
    keyFrames = in->U16();
    loops = in->U16();
    return in->IsComplete();
}
