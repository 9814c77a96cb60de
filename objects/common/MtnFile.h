//
// A motion file (MTN), as Hohl 2004, appendix A, describes it and as real files are.
//
// The same reader is used on the robot and on the host.  It turns bytes into a motion, or into an
// error text with section and offset; then the motion is empty.  The length of a file follows from
// the numbers of its key frames and joints.  A section size that differs from it is only a warning,
// because real files have such sizes (SITLOS01.MTN).
//

#ifndef MtnFile_h_DEFINED
#define MtnFile_h_DEFINED

#include <stddef.h>

#include <string>
#include <vector>

#include "FixedTypes.h"
#include "RobotDescription.h"

// Key frames and interpolation counts are multiples of this (section 0, frame rate).
const Sint32 MTN_FRAME_MS = 16;

// Largest angle of a joint: one full turn.  The mechanical stops lie within +-150 degrees.
const Sint32 MTN_MAX_ANGLE_URAD = 6283186;

// Largest angle of the body's attitude: ten turns, because a motion may turn the body several
// times.  The attitude is not played.
const Sint32 MTN_MAX_ATTITUDE_URAD = 62831853;

// A key frame index must fit SetValue and the remote control: -1..32767 (Hohl 2004, table 3.6).
const Sint32 MTN_MAX_KEYFRAMES = 32767;

// An angle that is beyond a software limit by this or less counts as being at the limit.  The
// vendor's files have 147 degrees as 2565640, which is 6 micro-radians too much.
const Sint32 MTN_LIMIT_TOLERANCE_URAD = 20;

// Largest number of interpolation frames between two key frames: one minute.  In 3440 known files
// the largest is 150.
const Sint32 MTN_MAX_INTERPOLATION = 3749;

const Sint32 MTN_MAX_JOINTS = 64;

class MtnFile {
public:
    MtnFile();

    // Reads a whole file.  Returns false, and is an empty motion, when the bytes are no motion.
    bool Read(const Uint8* bytes, size_t size);

    // Why Read() or MapTo() returned false: "section 3, offset 516: ...".
    const std::string& Error() const { return error_; }

    // Texts about unusual but harmless content, in the order of the file.
    const std::vector<std::string>& Warnings() const { return warnings_; }

    // Finds the joint or plunger of `robot` for each joint of the file, by locator; the design
    // label is not used.  Returns false with an Error() when the robot has no such joint.  Adds a
    // warning for each joint that leaves its software limits.  Call after Read().
    bool MapTo(const RobotConstants* robot);

    // Index in RobotConstants::joints of the file's joint `j`; -1 when it is a plunger.
    // Valid after MapTo().
    int RobotJoint(int j) const { return robotJoint_[j]; }

    // Index in RobotConstants::plungers of the file's joint `j`; -1 when joint `j` is no plunger.
    // A plunger, which moves an ear, has two positions: it is on in a key frame when its Angle() is
    // not 0.  Valid after MapTo().
    int RobotPlunger(int j) const { return robotPlunger_[j]; }

    int NumKeyFrames() const { return numKeyFrames_; }
    int NumJoints() const { return (int)locators_.size(); }
    const std::string& Locator(int j) const { return locators_[j]; }
    const std::string& Name() const { return name_; }
    const std::string& Creator() const { return creator_; }
    const std::string& DesignLabel() const { return designLabel_; }
    int MajorVersion() const { return majorVersion_; }
    int MinorVersion() const { return minorVersion_; }

    // Angle of the file's joint `j` in key frame `k`, urad.
    Sint32 Angle(int k, int j) const { return angles_[k * NumJoints() + j]; }

    // Roll, pitch, yaw (axis 0, 1, 2) of the body in key frame `k`, urad.
    Sint32 Attitude(int k, int axis) const { return attitudes_[k * 3 + axis]; }

    // Number of interpolation frames between key frames k and k + 1.
    Sint32 Interpolation(int k) const { return interpolations_[k]; }

    // The time of key frame `k`, in ms after key frame 0.  A gap with interpolation count n lasts
    // (n + 1) x 16 ms.
    Sint32 TimeMs(int k) const;

    // TimeMs() of the last key frame; 0 for an empty motion.
    Sint32 DurationMs() const;

private:
    class Cursor;

    void Clear();
    bool Refuse(const Cursor& at, const std::string& why);
    bool ReadSections(Cursor* cursor);
    bool ReadHeader(Cursor* cursor);
    bool ReadNames(Cursor* cursor);
    bool ReadJoints(Cursor* cursor);
    bool ReadKeyFrames(Cursor* cursor);
    bool ReadKeyFrame(Cursor* cursor);
    bool BeginSection(Cursor* cursor, Uint32 number, Uint32 smallest);
    bool EndSection(Cursor* cursor, Uint32 next);
    bool FindRobotParts(const RobotConstants* robot);
    std::string WhyNoJoint(const RobotConstants* robot, int j) const;

    std::string error_;
    std::vector<std::string> warnings_;
    Sint32 numKeyFrames_;
    int majorVersion_, minorVersion_;
    std::string name_, creator_, designLabel_;
    std::vector<std::string> locators_;
    std::vector<size_t> locatorAt_;       // offset of each locator in the file
    std::vector<Sint32> angles_;          // [key frame][joint]
    std::vector<Sint32> attitudes_;       // [key frame][roll, pitch, yaw]
    std::vector<Sint32> interpolations_;  // [gap]
    std::vector<int> robotJoint_, robotPlunger_;
};

#endif  // MtnFile_h_DEFINED
