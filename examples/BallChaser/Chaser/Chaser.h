//
// Chaser plays: it hears what BallEyes sees, and tells Walker how to walk.
//
//   Chaser.Sight <- BallEyes.Sight
//   Chaser.Walk -> Walker.Command
//
// Player decides; this object takes its decisions to Walker.  A file on the stick says which goal
// is the other team's.
//

#ifndef Chaser_h_DEFINED
#define Chaser_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>

#include "Player.h"
#include "def.h"

class Chaser : public OObject {
public:
    Chaser() : state_(Player::SEARCH) {}
    virtual ~Chaser() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifySight(const ONotifyEvent& event);

private:
    void ReadGoal();

    Player player_;
    Player::State state_;  // the state that was printed last
};

#endif  // Chaser_h_DEFINED
