//
// The memory for one picture of the camera, which RCServer keeps for the client that has asked for
// it.
//

#ifndef PictureSlot_h_DEFINED
#define PictureSlot_h_DEFINED

#include "RemoteCamera.h"

// One layer of an image of the camera, with the bytes that the robot has sent.
struct CameraLayer {
    Uint32 frame;  // frame number of the image
    Uint16 width;  // in pixels
    Uint16 height;
    const Uint8* bytes;
    Uint32 size;  // in bytes
};

class PictureSlot {
public:
    PictureSlot() : owner_(-1), layer_(0), lastFrame_(0), isHere_(false) {}

    // Returns the client to which the slot belongs; -1 if it belongs to no client.
    int Owner() const { return owner_; }

    // Returns whether the owner has not asked for the picture or for a part of it in the last two
    // seconds, so that another client may take the slot.
    bool IsForgotten(Uint32 frame) const { return frame - lastFrame_ >= FORGOTTEN_FRAMES; }

    // Gives the slot to a client, which waits for a picture from now on.
    void Take(int client, int layer, Uint32 frame);

    // Empties the slot, so that any client may take it.
    void Clear() { owner_ = -1; }

    // Records that the owner has asked for a part of the picture, so that the owner keeps the slot
    // for two more seconds.
    void Touch(Uint32 frame) { lastFrame_ = frame; }

    int Layer() const { return layer_; }
    bool IsWaiting() const { return owner_ >= 0 && !isHere_; }
    bool IsHere() const { return isHere_; }

    // Stores a copy of `layer`, for which the owner waits.  REQUIRES: IsWaiting().
    void Put(const CameraLayer& layer);

    // Returns the number of parts of the picture.  REQUIRES: IsHere().
    int NumParts() const;

    // Writes the head (RcPicturePart) of part number `part` of the picture to `out`, and then the
    // bytes of this part.  REQUIRES: IsHere(); 0 <= part < NumParts().
    void WritePart(int part, RcWriter* out) const;

private:
    // Time after the owner's last request from which on another client may take the slot: two
    // seconds, in frames of 8 ms.
    static const Uint32 FORGOTTEN_FRAMES = 250;

    int owner_;
    int layer_;
    Uint32 lastFrame_;  // frame of the owner's last request
    bool isHere_;
    CameraLayer kept_;  // the picture's layer; CameraLayer::bytes is not used
    Uint8 bytes_[RC_MAX_PICTURE];
};

#endif  // PictureSlot_h_DEFINED
