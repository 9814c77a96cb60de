#include "HttpServer.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/OUnits.h>
#include <OPENR/core_macro.h>

#include <stdio.h>
#include <string.h>

HttpServer::HttpServer() : isFound_(false), frame_(0), isStopped_(false)
{
    for (int j = 0; j < NUM_JOINTS; j++) {
        joint_[j] = oprimitiveID_UNDEF;
        element_[j] = -1;
        angle_[j] = 0;
    }
    for (int i = 0; i < NUM_CONNECTIONS; i++) {
        connection_[i].request = 0;
        connection_[i].answer = 0;
        connection_[i].requestSize = 0;
    }
}

OStatus
HttpServer::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;

    ipstack_ = antStackRef("IPStack");
    if (OpenJoints() != oSUCCESS) return oFAIL;
    return NewBuffers();
}

OStatus
HttpServer::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;

    for (int i = 0; i < NUM_CONNECTIONS; i++) Listen(i);
    OSYSPRINT(("HttpServer: http on TCP port %d\n", PORT));
    return oSUCCESS;
}

OStatus
HttpServer::DoStop(const OSystemEvent&)
{
    isStopped_ = true;
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
HttpServer::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// Opens the joints.  Leaves out a joint that the robot does not have, so the page does not show it.
OStatus
HttpServer::OpenJoints()
{
    for (int j = 0; j < NUM_JOINTS; j++) {
        const OStatus status = OPENR::OpenPrimitive(JOINTS[j].locator, &joint_[j]);
        if (status == oSUCCESS || status == oNOT_FOUND) continue;
        OSYSLOG1((osyslogERROR, "HttpServer: cannot open %s, status %u", JOINTS[j].locator,
                  (unsigned)status));
        return status;
    }
    return oSUCCESS;
}

// Keeps the newest angles, so that a request can be answered at once.
void
HttpServer::NotifySensor(const ONotifyEvent& event)
{
    OSensorFrameVectorData* vector = (OSensorFrameVectorData*)event.Data(0);
    if (!isFound_) FindElements(vector);
    for (int j = 0; j < NUM_JOINTS; j++) {
        if (element_[j] < 0) continue;
        const int last = (int)vector->GetInfo(element_[j])->numFrames - 1;
        angle_[j] = vector->GetData(element_[j])->frame[last].value;
    }
    frame_ = vector->GetInfo(0)->frameNumber + vector->GetInfo(0)->numFrames - 1;
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

void
HttpServer::FindElements(OSensorFrameVectorData* vector)
{
    isFound_ = true;
    for (int j = 0; j < NUM_JOINTS; j++) {
        if (joint_[j] == oprimitiveID_UNDEF) continue;
        for (int e = 0; e < (int)vector->vectorInfo.numData; e++) {
            if (vector->GetInfo(e)->primitiveID == joint_[j]) element_[j] = e;
        }
    }
}

// Writes header and body of the answer to a complete request, and returns their size.  Writes the
// body first, because the header has its size.
int
HttpServer::Answer(const char* request, char* answer) const
{
    const char* status = "200 OK";
    const char* type = "text/plain";
    char* body = answer + HTTP_HEADER_SIZE;
    int size = 0;
    if (strncmp(request, "GET ", 4) != 0) {
        status = "501 Not Implemented";
        size = sprintf(body, "only GET\n");
    } else if (strncmp(request + 4, "/ ", 2) == 0) {
        type = "text/html";
        size = WriteJoints(true, body);
    } else if (strncmp(request + 4, "/joints ", 8) == 0) {
        size = WriteJoints(false, body);
    } else {
        status = "404 Not Found";
        size = sprintf(body, "there are / and /joints\n");
    }
    const int headerSize = sprintf(answer,
                                   "HTTP/1.0 %s\r\nContent-Type: %s\r\nContent-Length: %d\r\n"
                                   "Connection: close\r\n\r\n", status, type, size);
    memmove(answer + headerSize, body, size);
    return headerSize + size;
}

// Writes the joints.  A joint takes at most 35 bytes, so a page with its header has less than 1024
// bytes: see Send().
int
HttpServer::WriteJoints(bool isPage, char* text) const
{
    char* end = text;
    end += sprintf(end, isPage ? "<html><head><meta http-equiv=\"refresh\" content=\"1\">"
                                 "<title>AIBO</title></head><body><h1>Frame %u</h1><table>\n"
                               : "frame %u\n", (unsigned)frame_);
    for (int j = 0; j < NUM_JOINTS; j++) {
        if (element_[j] < 0) continue;
        end += sprintf(end, isPage ? "<tr><td>%s<td>%.1f\n"
                                   : "%s: %.1f\n", JOINTS[j].name,
                       degrees(angle_[j] / 1000000.0));
    }
    if (isPage) end += sprintf(end, "</table></body></html>\n");
    return (int)(end - text);
}
