// Finds a pink ball as ball programs of the robot do: the camera marks its pixels in layer C, and
// says in the tag how many there are.
#ifndef BallFinder_h_DEFINED
#define BallFinder_h_DEFINED

#include <OPENR/OFbkImage.h>
#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

class BallFinder : public OObject {
public:
    BallFinder() {}
    virtual ~BallFinder() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyImage(const ONotifyEvent& event);
};

#endif  // BallFinder_h_DEFINED
