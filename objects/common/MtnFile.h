//
// A motion file (MTN), as Hohl 2004, appendix A, describes it and as real files are.
//
// One reader for the robot and for the host: bytes in; a motion, or an error text that
// names section and offset, out.  Nothing is half loaded: after a refusal the motion is
// empty.  The length of a file follows from its key frames and joints; a section size
// that says something else is a warning (SITLOS01.MTN, a real file, has one).
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

// Beyond one full turn no angle makes sense: the mechanical stops lie within +-150 degrees.
const Sint32 MTN_MAX_ANGLE_URAD = 6283186;

// The attitude of the body is not played; ten turns leave room for a dance.
const Sint32 MTN_MAX_ATTITUDE_URAD = 62831853;

// A key frame index must fit SetValue and the remote control: -1..32767 (Hohl 2004, table 3.6).
const Sint32 MTN_MAX_KEYFRAMES = 32767;

// How far beyond a software limit an angle still is at the limit: the vendor's files store
// 147 degrees as 2565640, 6 micro-radians too much.
const Sint32 MTN_LIMIT_TOLERANCE_URAD = 20;

// One minute between two key frames.  The largest count in 3440 known files is 150.
const Sint32 MTN_MAX_INTERPOLATION = 3749;

const Sint32 MTN_MAX_JOINTS = 64;

class MtnFile {
public:
    MtnFile();

    // Reads a whole file.  Returns false and keeps nothing when the bytes are no motion.
    bool Read(const Uint8* bytes, size_t size);

    // Why Read() or MapTo() returned false: "section 3, offset 516: ...".
    const std::string& Error() const { return error_; }

    // What is odd but harmless, in the order met.
    const std::vector<std::string>& Warnings() const { return warnings_; }

    // Which joint or plunger of `robot` each joint of the file is, by locator; the design
    // label plays no part.  Returns false with an Error() when the robot lacks one, or when
    // a name is something else on this robot, and adds a warning for each joint that leaves
    // the software limits.  Call after Read().
    bool MapTo(const RobotConstants* robot);

    // Index in RobotConstants::joints of the file's joint `j`; -1 when it is a plunger.
    // Valid after MapTo().
    int RobotJoint(int j) const { return robotJoint_[j]; }

    // Index in RobotConstants::plungers of the file's joint `j`; -1 when joint `j` is
    // no plunger.  A plunger has two positions, as an ear has: in a key frame it is on when
    // its Angle() is not 0.  Valid after MapTo().
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

    // When key frame `k` is reached, in ms from key frame 0: the sum of (n + 1) x 16.
    Sint32 TimeMs(int k) const;

    // TimeMs() of the last key frame; 0 of an empty motion.
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
    std::vector<size_t> locatorAt_;       // offset of each in the file
    std::vector<Sint32> angles_;          // [key frame][joint]
    std::vector<Sint32> attitudes_;       // [key frame][roll, pitch, yaw]
    std::vector<Sint32> interpolations_;  // [gap]
    std::vector<int> robotJoint_, robotPlunger_;
};

#endif  // MtnFile_h_DEFINED
