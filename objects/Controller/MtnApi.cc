//
// Implements the functions of include/device/mtn.h (Hohl 2004, section 5.3.7).
//

#include <device/mtn.h>

#include <string.h>

#include "ControllerApi.h"
#include "MtnFile.h"
#include "MtnName.h"

struct MtnMotion {
    MtnFile file;
    char name[MTN_NAME_SIZE];
    // The key frame that the motion has reached last; -1 if the motion does not play.
    Sint32 keyFrame;
};

static MtnMotion* thePlaying = 0;  // the motion of the last mtn_play() while it plays; otherwise 0
static std::string theError;       // error text of the last mtn_new(); "" if it did not fail

// Reads the file `filename` into `motion`.  On failure, returns false and sets theError.
static bool
Load(const char* filename, MtnMotion* motion)
{
    ControllerCore* core = GetControllerCore();
    std::vector<Uint8> bytes;
    if (core == 0 || filename == 0) {
        theError = core == 0 ? "the robot is not running" : "the file name is a null pointer";
        return false;
    }
    if (!MtnFileName(filename, motion->name, &theError)) return false;
    if (!core->Port()->ReadFile(std::string(MTN_DIRECTORY) + motion->name, &bytes, &theError))
        return false;
    if (motion->file.Read(bytes.empty() ? 0 : &bytes[0], bytes.size()) &&
        motion->file.MapTo(core->Robot())) {
        return true;
    }
    theError = std::string(motion->name) + ": " + motion->file.Error();
    return false;
}

MTN*
mtn_new(const char* filename)
{
    theError = "";
    MtnMotion* motion = new MtnMotion;
    motion->keyFrame = -1;
    if (Load(filename, motion)) return motion;
    delete motion;
    return 0;
}

const char*
mtn_get_error(void)
{
    return theError.empty() ? 0 : theError.c_str();
}

void
mtn_delete(MTN* motion)
{
    if (thePlaying == motion) thePlaying = 0;
    delete motion;
}

// Plays the motion.  The motion counts as playing from now on, although JointMover may first move
// the robot to the first key frame of the motion.  While another motion plays, sends no command,
// because JointMover would refuse the command and report its motion as over.  If both motions were
// of the same file, the motion that plays would then count as over, too.
void
mtn_play(MTN* motion)
{
    ControllerCore* core = GetControllerCore();
    if (motion == 0 || core == 0) return;
    if (thePlaying != 0 && !mtn_is_over(thePlaying)) {
        core->Port()->Remark("mtn_play: the motion before is not over; ignored");
        return;
    }
    // Marks the earlier motion as over.  It has reached its last key frame, but JointMover has not
    // reported its end yet.  That report will not mark it, because reports change only the motion
    // in `thePlaying`, which is the new motion from the next line on.
    if (thePlaying != 0) thePlaying->keyFrame = -1;
    thePlaying = motion;
    motion->keyFrame = 0;
    MoverCommand command;
    memset(&command, 0, sizeof(command));
    command.kind = moverkindPLAY;
    command.loops = 1;
    memcpy(command.file, motion->name, sizeof(command.file));
    core->Port()->SendMover(command);
}

int
mtn_get_length(MTN* motion)
{
    return motion != 0 ? motion->file.DurationMs() : 0;
}

int
mtn_get_time(MTN* motion)
{
    if (motion == 0) return 0;
    return motion->keyFrame < 0 ? motion->file.DurationMs() : motion->file.TimeMs(motion->keyFrame);
}

// Returns 1 when the motion does not play, or has reached its last key frame.  Compares key frames
// and not times, because JointMover reports the progress of a motion only at key frames.  A motion
// with a single key frame is an exception, because its last key frame is also its first: it is over
// when JointMover has reported its end.
int
mtn_is_over(MTN* motion)
{
    if (motion == 0 || motion->keyFrame < 0) return 1;
    const int last = motion->file.NumKeyFrames() - 1;
    return last > 0 && motion->keyFrame >= last;
}

// Stores the progress of the motion that plays.  Ignores reports about motions of other files,
// because the remote control may play motions as well.
void
SetMotionValues(const SetValueMessage& message)
{
    if (thePlaying == 0 || memcmp(message.file, thePlaying->name, sizeof(message.file)) != 0)
        return;
    if (message.isOver) {
        thePlaying->keyFrame = -1;
        thePlaying = 0;
    } else if (message.keyFrame >= 0 && message.keyFrame < thePlaying->file.NumKeyFrames()) {
        thePlaying->keyFrame = message.keyFrame;
    }
}
