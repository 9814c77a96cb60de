//
// Answers the requests of the remote control for pictures of the camera.
//

#include "RequestHandler.h"

#include "TextFormat.h"

// Asks the camera for one picture.  Refuses if another client has a picture and has asked for a
// part of it lately, because RCServer has memory for one picture only.
int
RequestHandler::AskForPicture(RcReader* in)
{
    const int layer = in->U8();
    if (!in->IsComplete()) return FailSize();
    if (layer >= NUM_RC_LAYERS) {
        return Fail(rcerrorNO_SUCH_DEVICE,
                    TextFormat("layer %d: there are 0 (H), 1 (M), 2 (L) and 3 (C)", layer));
    }
    const bool isFree = picture_.Owner() < 0 || picture_.Owner() == client_;
    if (!isFree && !picture_.IsForgotten(sensors_.frame)) {
        return Fail(rcerrorBUSY, "another client fetches a picture; try again");
    }
    picture_.Reserve(client_, layer, sensors_.frame);
    port_->WantImage(true);
    return rcOK;
}

int
RequestHandler::TellPicturePart(RcReader* in, RcWriter* out)
{
    const int part = in->U16();
    if (!in->IsComplete()) return FailSize();
    if (picture_.Owner() != client_) {
        return Fail(rcerrorNO_PICTURE, "no picture was asked for, or another client has taken over");
    }
    picture_.Touch(sensors_.frame);
    if (!picture_.IsHere()) {
        return Fail(rcerrorBUSY, "the camera has not sent the picture yet; try again");
    }
    if (part >= picture_.NumParts()) {
        return Fail(rcerrorBAD_VALUE, TextFormat("part %d: the picture has %d, counted from 0", part,
                                                 picture_.NumParts()));
    }
    picture_.WritePart(part, out);
    return rcOK;
}

void
RequestHandler::SetPicture(const CameraLayer& layer)
{
    if (!picture_.IsWaiting()) return;
    picture_.Put(layer);
    port_->WantImage(false);
}

void
RequestHandler::EndPicture(int client)
{
    if (picture_.Owner() != client) return;
    if (picture_.IsWaiting()) port_->WantImage(false);
    picture_.Clear();
}
