#include "MtnFile.h"

#include <string.h>

#include "ByteOrder.h"
#include "TextFormat.h"

// Reads the bytes of a file one after the other.  REQUIRES: before a number is read, Has() has
// returned true for its size.
class MtnFile::Cursor {
public:
    Cursor(const Uint8* bytes, size_t size)
        : bytes_(bytes), size_(size), at_(0), section(-1), start(0), declaredSize(0)
    {
    }

    bool Has(size_t count) const { return size_ - at_ >= count; }
    size_t Left() const { return size_ - at_; }
    size_t At() const { return at_; }
    size_t Size() const { return size_; }
    void MoveTo(size_t at) { at_ = at; }

    Uint8 U8() { return bytes_[at_++]; }
    Uint16 U16()
    {
        at_ += 2;
        return GetU16(bytes_ + at_ - 2);
    }
    Uint32 U32()
    {
        at_ += 4;
        return GetU32(bytes_ + at_ - 4);
    }
    Sint32 S32()
    {
        at_ += 4;
        return GetS32(bytes_ + at_ - 4);
    }
    Uint32 PeekU32(size_t at) const { return GetU32(bytes_ + at); }

    // Reads a string: a length byte and then this number of characters.  Returns false when the
    // file ends before the last character.
    bool String(std::string* text)
    {
        if (!Has(1) || !Has(1 + (size_t)bytes_[at_])) return false;
        const size_t length = U8();
        text->assign((const char*)bytes_ + at_, length);
        at_ += length;
        return true;
    }

private:
    const Uint8* bytes_;
    size_t size_;
    size_t at_;

public:
    int section;          // number of the section that is being read; -1 before the first section
    size_t start;         // offset in the file at which this section begins
    Uint32 declaredSize;  // size of the section in bytes, as the section itself says
};

MtnFile::MtnFile()
{
    Clear();
}

void
MtnFile::Clear()
{
    numKeyFrames_ = 0;
    majorVersion_ = minorVersion_ = 0;
    name_ = creator_ = designLabel_ = "";
    locators_.clear();
    locatorAt_.clear();
    angles_.clear();
    attitudes_.clear();
    interpolations_.clear();
    robotJoint_.clear();
}

bool
MtnFile::Refuse(const Cursor& at, const std::string& why)
{
    const std::string where =
        at.section < 0 ? std::string("header") : TextFormat("section %d", at.section);
    error_ = where + TextFormat(", offset %lu: ", (unsigned long)at.At()) + why;
    Clear();
    return false;
}

bool
MtnFile::Read(const Uint8* bytes, size_t size)
{
    Clear();
    error_ = "";
    warnings_.clear();
    Cursor cursor(bytes, size);
    if (!cursor.Has(4))
        return Refuse(cursor, TextFormat("the file has only %lu bytes", (unsigned long)size));
    if (memcmp(bytes, "OMTN", 4) != 0)
        return Refuse(cursor, "a motion file begins with 'OMTN', this one does not");
    cursor.MoveTo(4);
    return ReadSections(&cursor);
}

bool
MtnFile::ReadSections(Cursor* cursor)
{
    if (!ReadHeader(cursor) || !ReadNames(cursor) || !ReadJoints(cursor) || !ReadKeyFrames(cursor))
        return false;
    if (cursor->Left() > 0) {
        warnings_.push_back(
            TextFormat("%lu bytes after section 3 are ignored", (unsigned long)cursor->Left()));
    }
    return true;
}

// Reads the number and the size of a section.  Returns false with an error if the file has less
// than `smallest` bytes left, or if the section has another number than `number`.
bool
MtnFile::BeginSection(Cursor* cursor, Uint32 number, Uint32 smallest)
{
    cursor->section = (int)number;
    cursor->start = cursor->At();
    if (!cursor->Has(smallest)) {
        return Refuse(*cursor, TextFormat("needs %u bytes, the file has %lu left", smallest,
                                          (unsigned long)cursor->Left()));
    }
    const Uint32 found = cursor->PeekU32(cursor->At());
    if (found != number)
        return Refuse(*cursor, TextFormat("section number is %u, expected %u", found, number));
    cursor->MoveTo(cursor->At() + 4);
    cursor->declaredSize = cursor->U32();
    return true;
}

// Moves to section `next`, which begins after the padding of the present section.  If the size that
// the present section declares does not lead to this place, looks for the section number `next` at
// two places: first after the padding, then after the declared size.  Moves to the first place that
// has this number.
bool
MtnFile::EndSection(Cursor* cursor, Uint32 next)
{
    const size_t length = cursor->At() - cursor->start;
    const size_t padded = (length + 3) / 4 * 4;
    if (cursor->declaredSize == padded) {
        if (!cursor->Has(padded - length))
            return Refuse(*cursor, "the file ends inside the padding");
        cursor->MoveTo(cursor->start + padded);
        return true;
    }
    const std::string sizes = TextFormat("size says %u bytes, its content has %lu",
                                         cursor->declaredSize, (unsigned long)padded);
    const size_t places[2] = { cursor->start + padded, cursor->start + cursor->declaredSize };
    for (int i = 0; i < 2; i++) {
        if (places[i] < cursor->At() || places[i] > cursor->Size() ||
            cursor->Size() - places[i] < 4)
            continue;
        if (cursor->PeekU32(places[i]) != next) continue;
        warnings_.push_back(TextFormat("section %d: ", cursor->section) + sizes);
        cursor->MoveTo(places[i]);
        return true;
    }
    cursor->MoveTo(cursor->start + 4);
    return Refuse(*cursor, sizes + TextFormat(", and section %u begins at neither place", next));
}

bool
MtnFile::ReadHeader(Cursor* cursor)
{
    if (!BeginSection(cursor, 0, 24)) return false;
    const Uint32 numSections = cursor->U32();
    majorVersion_ = cursor->U16();
    minorVersion_ = cursor->U16();
    const size_t countAt = cursor->At();
    numKeyFrames_ = cursor->U16();
    const size_t rateAt = cursor->At();
    const int rate = cursor->U16();
    cursor->U32();  // skips a reserved number
    if (numSections != 4)
        warnings_.push_back(TextFormat("section 0: says %u sections, a motion has 4", numSections));
    if (majorVersion_ != 1) {
        warnings_.push_back(TextFormat("section 0: version %d.%d, known are 1.1 and 1.2",
                                       majorVersion_, minorVersion_));
    }
    if (numKeyFrames_ < 1 || numKeyFrames_ > MTN_MAX_KEYFRAMES) {
        const int count = numKeyFrames_;
        cursor->MoveTo(countAt);
        return Refuse(*cursor,
                      TextFormat("%d key frames, must be 1 to %d", count, MTN_MAX_KEYFRAMES));
    }
    if (rate != MTN_FRAME_MS) {
        cursor->MoveTo(rateAt);
        return Refuse(*cursor,
                      TextFormat("frame rate is %d ms, only %d can be played", rate, MTN_FRAME_MS));
    }
    return EndSection(cursor, 1);
}

bool
MtnFile::ReadNames(Cursor* cursor)
{
    if (!BeginSection(cursor, 1, 12)) return false;
    std::string* const names[3] = { &name_, &creator_, &designLabel_ };
    static const char* const WHAT[3] = { "motion name", "creator", "design label" };
    for (int i = 0; i < 3; i++) {
        if (!cursor->String(names[i]))
            return Refuse(*cursor, TextFormat("the file ends inside the %s", WHAT[i]));
    }
    return EndSection(cursor, 2);
}

bool
MtnFile::ReadJoints(Cursor* cursor)
{
    if (!BeginSection(cursor, 2, 12)) return false;
    const int numJoints = cursor->U16();
    if (numJoints < 1 || numJoints > MTN_MAX_JOINTS) {
        cursor->MoveTo(cursor->At() - 2);
        return Refuse(*cursor, TextFormat("%d joints, must be 1 to %d", numJoints, MTN_MAX_JOINTS));
    }
    for (int j = 0; j < numJoints; j++) {
        std::string locator;
        locatorAt_.push_back(cursor->At());
        if (!cursor->String(&locator))
            return Refuse(*cursor, TextFormat("the file ends inside the locator of joint %d", j));
        for (size_t i = 0; i < locators_.size(); i++) {
            if (locators_[i] == locator)
                return Refuse(*cursor, "joint '" + locator.substr(0, 80) + "' is listed twice");
        }
        locators_.push_back(locator);
    }
    return EndSection(cursor, 3);
}

bool
MtnFile::ReadKeyFrames(Cursor* cursor)
{
    if (!BeginSection(cursor, 3, 12)) return false;
    const Uint32 type = cursor->U32();
    if (type != 0) {
        cursor->MoveTo(cursor->At() - 4);
        return Refuse(*cursor, TextFormat("data type is %u, only 0 (angles) is known", type));
    }
    const Uint32 frames = (Uint32)numKeyFrames_;
    // Computes the size of all key frames in 32 bits.  This is enough, because at most 32767 key
    // frames (MTN_MAX_KEYFRAMES) of 64 joints (MTN_MAX_JOINTS) have less than 9 MB.
    const Uint32 data = frames * (12 + 4 * (Uint32)NumJoints()) + 4 * (frames - 1);
    if (!cursor->Has(data)) {
        return Refuse(*cursor,
                      TextFormat("%u key frames of %d joints need %u bytes, the file has %lu left",
                                 frames, NumJoints(), data, (unsigned long)cursor->Left()));
    }
    if (cursor->declaredSize != 12 + data) {
        warnings_.push_back(
            TextFormat("section 3: size says %u bytes, %u key frames of %d joints have %u",
                       cursor->declaredSize, frames, NumJoints(), 12 + data));
    }
    angles_.reserve(frames * NumJoints());
    attitudes_.reserve(frames * 3);
    for (Uint32 k = 0; k < frames; k++) {
        if (!ReadKeyFrame(cursor)) return false;
    }
    return true;
}

// Reads a key frame and the interpolation count before it (the number of frames between this key
// frame and the key frame before).  The first key frame has no such count.
bool
MtnFile::ReadKeyFrame(Cursor* cursor)
{
    const int k = (int)(attitudes_.size() / 3);
    if (k > 0) {
        const Uint32 count = cursor->U32();
        if (count > (Uint32)MTN_MAX_INTERPOLATION) {
            cursor->MoveTo(cursor->At() - 4);
            return Refuse(
                *cursor,
                TextFormat("%u interpolation frames before key frame %d, at most %d make sense",
                           count, k, MTN_MAX_INTERPOLATION));
        }
        interpolations_.push_back((Sint32)count);
    }
    for (int i = 0; i < 3 + NumJoints(); i++) {
        const Sint32 angle = cursor->S32();
        const Sint32 bound = i < 3 ? MTN_MAX_ATTITUDE_URAD : MTN_MAX_ANGLE_URAD;
        if (angle > bound || angle < -bound) {
            cursor->MoveTo(cursor->At() - 4);
            static const char* const AXES[3] = { "roll", "pitch", "yaw" };
            const std::string what = i < 3 ? std::string(AXES[i]) : locators_[i - 3].substr(0, 80);
            return Refuse(*cursor, "key frame " + TextFormat("%d: ", k) + what +
                                       TextFormat(" is %d urad, beyond +-%d no angle makes sense",
                                                  angle, bound));
        }
        (i < 3 ? attitudes_ : angles_).push_back(angle);
    }
    return true;
}

// Returns the reason why the robot has no joint and no ear (plunger) with the locator of joint `j`:
// the locator is unknown, or it is the locator of another device.
std::string
MtnFile::JointProblem(const RobotConstants* robot, int j) const
{
    const char* const locator = locators_[j].c_str();
    const char* kind = 0;
    if (FindLed(robot, locator) >= 0) kind = "a light";
    if (FindSensor(robot, locator) >= 0) kind = "a sensor";
    if (locators_[j] == robot->camera.locator) kind = "the camera";
    const std::string name = "'" + locators_[j].substr(0, 80) + "'";
    if (kind == 0) return std::string("the ") + robot->design + " has no joint " + name;
    return name + " of the " + robot->design + " is " + kind + ", no joint";
}

bool
MtnFile::FindRobotParts(const RobotConstants* robot)
{
    error_ = "";
    robotJoint_.clear();
    robotPlunger_.clear();
    for (int j = 0; j < NumJoints(); j++) {
        robotJoint_.push_back(FindJoint(robot, locators_[j].c_str()));
        robotPlunger_.push_back(FindPlunger(robot, locators_[j].c_str()));
        if (robotJoint_[j] >= 0 || robotPlunger_[j] >= 0) continue;
        error_ = TextFormat("section 2, offset %lu: joint %d: ", (unsigned long)locatorAt_[j], j) +
                 JointProblem(robot, j);
        robotJoint_.clear();
        robotPlunger_.clear();
        return false;
    }
    return true;
}

bool
MtnFile::MapTo(const RobotConstants* robot)
{
    if (!FindRobotParts(robot)) return false;
    for (int j = 0; j < NumJoints(); j++) {
        if (robotJoint_[j] < 0) continue;
        const JointConstants& limits = robot->joints[robotJoint_[j]];
        for (int k = 0; k < numKeyFrames_; k++) {
            const Sint32 angle = Angle(k, j);
            if (angle >= limits.minUrad - MTN_LIMIT_TOLERANCE_URAD &&
                angle <= limits.maxUrad + MTN_LIMIT_TOLERANCE_URAD) {
                continue;
            }
            warnings_.push_back(
                TextFormat("key frame %d: %s is %d urad, outside its software limits %d to %d", k,
                           limits.name, angle, limits.minUrad, limits.maxUrad));
            break;
        }
    }
    return true;
}

Sint32
MtnFile::TimeMs(int k) const
{
    Sint32 frames = 0;
    for (int gap = 0; gap < k; gap++) frames += interpolations_[gap] + 1;
    return frames * MTN_FRAME_MS;
}

Sint32
MtnFile::DurationMs() const
{
    // A motion without key frames has a duration of 0, because TimeMs(-1) is 0.
    return TimeMs(numKeyFrames_ - 1);
}
