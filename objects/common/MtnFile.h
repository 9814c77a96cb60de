//
// MtnFile: reads motion files (MTN) in the format of Hohl 2004, appendix A, and accepts the
// differences from this format that real files have.
//
// A motion is a sequence of key frames, which are postures of the robot.  The frames between two
// key frames are interpolated.
//
// Robot and host use the same reader.  It converts the bytes to a motion.  When the bytes are no
// motion, the result is an error text with section and offset, and the motion is empty.  The length
// of a file follows from the numbers of its key frames and joints.  A section size that differs
// from this length is only a warning, because real files have such sizes (SITLOS01.MTN).
//

#ifndef MtnFile_h_DEFINED
#define MtnFile_h_DEFINED

#include <stddef.h>

#include <string>
#include <vector>

#include "FixedTypes.h"
#include "RobotDescription.h"

// Time unit of key frames and interpolation counts, in ms (section 0 of the file, frame rate).
const Sint32 MTN_FRAME_MS = 16;

// Largest angle of a joint that a motion may have: one full turn.  Greater angles are errors of the
// file, because the mechanical stops of all joints lie within +-150 degrees.
const Sint32 MTN_MAX_ANGLE_URAD = 6283186;

// Largest angle of the body's attitude (roll, pitch, yaw): ten turns, because a motion may turn the
// body several times.  The attitude is read but not played.
const Sint32 MTN_MAX_ATTITUDE_URAD = 62831853;

// Largest number of key frames.  The index of a key frame must stay in the range -1 to 32767 that
// Hohl 2004, table 3.6, gives for it.  Records of the log of motions have only 16 bits for it.
const Sint32 MTN_MAX_KEYFRAMES = 32767;

// Tolerance at a software limit: an angle that is beyond the limit by this or less counts as being
// at the limit.  For example, the vendor's files have 147 degrees as 2565640, which is 6
// microradians too much.
const Sint32 MTN_LIMIT_TOLERANCE_URAD = 20;

// Largest number of interpolation frames (MTN_FRAME_MS each) between two key frames.  With this
// number, the second key frame follows (3749 + 1) x 16 ms, that is one minute, after the first.  A
// larger number is taken for an error in the file: 3440 known files have at most 150.
const Sint32 MTN_MAX_INTERPOLATION = 3749;

const Sint32 MTN_MAX_JOINTS = 64;

class MtnFile {
public:
    MtnFile();

    // Reads the bytes of a whole file.  Returns false when the bytes are no motion; then this
    // object is an empty motion, and Error() has the reason.
    bool Read(const Uint8* bytes, size_t size);

    // Returns the reason why Read() or MapTo() returned false, such as "section 3, offset 516:
    // ...".
    const std::string& Error() const { return error_; }

    // Returns texts about unusual but harmless content of the motion file, in the order of the
    // content.
    const std::vector<std::string>& Warnings() const { return warnings_; }

    // Finds the joint or ear (plunger) of `robot` for each joint of the file, by its locator
    // (OPEN-R name); the design label of the file is not used.  Returns false with an Error() when
    // the robot has no such joint.  Adds a warning for each joint that leaves its software limits.
    // REQUIRES: Read() has returned true.
    bool MapTo(const RobotConstants* robot);

    // Returns the index in RobotConstants::joints of the file's joint `j`, or -1 when joint `j` is
    // an ear.  Valid after MapTo().
    int RobotJoint(int j) const { return robotJoint_[j]; }

    // Returns the index in RobotConstants::plungers of the file's joint `j`, or -1 when joint `j`
    // is no ear.  An ear is moved by a plunger, which is either on or off.  In a key frame, an
    // Angle() of 0 means off; any other value means on.  Valid after MapTo().
    int RobotPlunger(int j) const { return robotPlunger_[j]; }

    int NumKeyFrames() const { return numKeyFrames_; }
    int NumJoints() const { return (int)locators_.size(); }
    const std::string& Locator(int j) const { return locators_[j]; }
    const std::string& Name() const { return name_; }
    const std::string& Creator() const { return creator_; }
    const std::string& DesignLabel() const { return designLabel_; }
    int MajorVersion() const { return majorVersion_; }
    int MinorVersion() const { return minorVersion_; }

    // Returns the angle of the file's joint `j` in key frame `k`, in urad (10^-6 rad).
    Sint32 Angle(int k, int j) const { return angles_[k * NumJoints() + j]; }

    // Returns roll, pitch or yaw (`axis` 0, 1 or 2) of the body in key frame `k`, in urad.
    Sint32 Attitude(int k, int axis) const { return attitudes_[k * 3 + axis]; }

    // Returns the number of interpolation frames between key frames `k` and `k` + 1.
    Sint32 Interpolation(int k) const { return interpolations_[k]; }

    // Returns the time of key frame `k`, in ms after key frame 0.  A gap between two key frames
    // with interpolation count n lasts (n + 1) x 16 ms.
    Sint32 TimeMs(int k) const;

    // Returns the time from key frame 0 to the last key frame, in ms; 0 for an empty motion.
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
    std::string JointProblem(const RobotConstants* robot, int j) const;

    std::string error_;
    std::vector<std::string> warnings_;
    Sint32 numKeyFrames_;
    int majorVersion_, minorVersion_;
    std::string name_, creator_, designLabel_;
    std::vector<std::string> locators_;
    std::vector<size_t> locatorAt_;       // offset of each locator in the file
    std::vector<Sint32> angles_;          // angles_[key frame * NumJoints() + joint], in urad
    std::vector<Sint32> attitudes_;       // roll, pitch and yaw of each key frame, in urad
    // Number of interpolation frames of each gap between key frames.
    std::vector<Sint32> interpolations_;
    std::vector<int> robotJoint_, robotPlunger_;
};

#endif  // MtnFile_h_DEFINED
