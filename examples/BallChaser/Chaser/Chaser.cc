#include "Chaser.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include <stdio.h>
#include <string.h>

static const char* const FILE_NAME = "/MS/OPEN-R/MW/CONF/PLAYER.CFG";

static const char* const STATE_NAMES[] = {"I search the ball", "I go to the ball",
                                          "I walk around the ball", "I push the ball"};

OStatus
Chaser::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    ReadGoal();
    return oSUCCESS;
}

OStatus
Chaser::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Chaser::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Chaser::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// Reads the colour of the goal to play at.  Without the file, or with another word in it, the goal
// is the sky-blue one.
void
Chaser::ReadGoal()
{
    char word[16] = "";
    FILE* file = fopen(FILE_NAME, "r");
    if (file != 0) {
        if (fgets(word, sizeof(word), file) == 0) word[0] = 0;
        fclose(file);
    }
    const bool isYellow = strncmp(word, "YELLOW", 6) == 0;
    player_.SetGoal(isYellow ? YELLOW_GOAL : SKY_BLUE_GOAL);
    OSYSPRINT(("Chaser: I play at the %s goal\n", isYellow ? "yellow" : "sky-blue"));
}

void
Chaser::NotifySight(const ONotifyEvent& event)
{
    player_.See(*(const Sight*)event.Data(0));
    if (player_.GetState() != state_) {
        state_ = player_.GetState();
        OSYSPRINT(("Chaser: %s\n", STATE_NAMES[state_]));
    }
    const WalkCommand command = player_.Command();
    subject[sbjWalk]->SetData(&command, sizeof(command));
    subject[sbjWalk]->NotifyObservers();
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}
