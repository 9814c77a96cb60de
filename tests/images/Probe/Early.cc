#include "Early.h"

#include <stdio.h>

#include <sstream>

static sError sent, asked, registered, ordered;
static RID    box;
static RID    ownBox;

bool
SendEarly(OID own)
{
    FILE* file = fopen("/MS/OPEN-R/MW/DATA/P/OWN.TXT", "r");
    if (file == 0) return false;
    fclose(file);
    sent       = Send(own, earlyEntry, 0, 0);
    registered = Register(own, "early bird");
    TimeEventInfoWithRelativeTime soon(RelativeTime(0, 500));
    ordered = SetTimeEvent(&soon, own, earlyEntry, 0, 0, 0);
    OID  talker;
    char question[] = "who?";
    Find("talker", &talker);
    asked = SendWithRBox(talker, oentryBASE + 6, question, sizeof(question), &box);
    FILE* ask = fopen("/MS/OPEN-R/MW/DATA/P/ASK.TXT", "r");
    if (ask == 0) return true;
    fclose(ask);
    SendWithRBox(own, earlyEntry, 0, 0, &ownBox);
    return true;
}

void
AskAgain(OID own)
{
    if (!ownBox.IsValid()) return;
    for (int i = 0; i < 2; i++) {
        RID another;
        SendWithRBox(own, earlyEntry, 0, 0, &another);
    }
}

std::string
AnswerEarly()
{
    std::ostringstream out;
    out << "sent " << sent << ", registered " << registered << ", ordered " << ordered << ", asked " << asked;
    char         reply[16] = "";
    size_t       got       = 0;
    RelativeTime none(0, 1);
    if (Receive(box, reply, sizeof(reply), &got, &none) == sSUCCESS) out << ", " << reply;
    return out.str();
}
