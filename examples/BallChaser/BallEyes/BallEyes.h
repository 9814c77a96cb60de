//
// BallEyes looks for the ball and the goals.
//
//   BallEyes.Image <- OVirtualRobotComm.FbkImageSensor
//   BallEyes.Sensor <- OVirtualRobotComm.Sensor
//   BallEyes.Sight -> Chaser.Sight
//
// The camera's colour detection marks the pixels in layer C, 88 x 72 pixels, 25 times a second.
// Where a pixel looks depends on the neck, so this object keeps the angles of the neck of the last
// frames, and takes those of the frame in which the picture was made.
//

#ifndef BallEyes_h_DEFINED
#define BallEyes_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <OPENR/ODataFormats.h>

#include "Eyes.h"
#include "def.h"

class BallEyes : public OObject {
public:
    BallEyes();
    virtual ~BallEyes() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyImage(const ONotifyEvent& event);
    void NotifySensor(const ONotifyEvent& event);

private:
    static const int NUM_FRAMES = 32;  // frames of which the neck is kept: 256 ms
    static const longword NO_FRAME = 0xffffffff;

    OStatus SetColourTables();
    void FindElements(OSensorFrameVectorData* vector);

    OPrimitiveID camera_;
    OPrimitiveID tiltJoint_;
    OPrimitiveID panJoint_;
    int tiltElement_;  // elements of the joints in sensor vectors; -1 before the first vector
    int panElement_;
    // Element n % NUM_FRAMES has the number of frame n, and its angles in rad.
    longword frame_[NUM_FRAMES];
    double tilt_[NUM_FRAMES];
    double pan_[NUM_FRAMES];
    Eyes eyes_;
};

#endif  // BallEyes_h_DEFINED
