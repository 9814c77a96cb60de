//
// Camera takes one picture and writes it to the Memory Stick.
//
//   Camera.Image <- OVirtualRobotComm.FbkImageSensor
//
// The camera sends 25 vectors a second, each with the picture in four layers.  This object uses the
// largest layer, 176 x 144.
//

#ifndef Camera_h_DEFINED
#define Camera_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <OPENR/ODataFormats.h>

#include "def.h"

class Camera : public OObject {
public:
    Camera();
    virtual ~Camera() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyImage(const ONotifyEvent& event);

private:
    static const int NUM_SKIPPED = 10;  // pictures to skip, because the camera has just been set up

    void SetUp();
    void Convert(OFbkImageVectorData* vector);
    bool WriteFile() const;

    OPrimitiveID camera_;
    int numSeen_;  // number of pictures received so far
    byte* rgb_;    // pixels of the picture, row by row; 0 until the picture was taken
    int width_;
    int height_;
};

#endif  // Camera_h_DEFINED
