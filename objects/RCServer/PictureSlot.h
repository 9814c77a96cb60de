//
// The memory for one picture of the camera, which RCServer keeps for the client that has asked for
// it.
//

#ifndef PictureSlot_h_DEFINED
#define PictureSlot_h_DEFINED

#include "RemoteCamera.h"

// A layer of an image of the camera, with the bytes that the robot has sent.
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

    // Returns the client to which this memory for a picture belongs; -1 if it belongs to no client.
    int Owner() const { return owner_; }

    // Returns whether the owner (the client to which this memory belongs) has not asked for the
    // picture or for a part of it in the last two seconds, so that another client may take the
    // memory.
    bool IsForgotten(Uint32 frame) const { return frame - lastFrame_ >= FORGOTTEN_FRAMES; }

    // Gives this memory for a picture to a client, which waits for a picture from now on.
    void Reserve(int client, int layer, Uint32 frame);

    // Takes this memory for a picture from its owner, so that any client may get it.
    void Clear() { owner_ = -1; }

    // Records that the client to which the picture belongs has asked for a part of it, so that this
    // client keeps the picture for two more seconds.
    void Touch(Uint32 frame) { lastFrame_ = frame; }

    int Layer() const { return layer_; }
    bool IsWaiting() const { return owner_ >= 0 && !isHere_; }
    bool IsHere() const { return isHere_; }

    // Stores a copy of `layer`, the picture for which a client waits.  REQUIRES: IsWaiting().
    void Put(const CameraLayer& layer);

    // Returns the number of parts of the picture.  REQUIRES: IsHere().
    int NumParts() const;

    // Writes the head (RcPicturePart) of part number `part` of the picture to `out`, and then the
    // bytes of this part.  REQUIRES: IsHere(); 0 <= part < NumParts().
    void WritePart(int part, RcWriter* out) const;

private:
    // Time for which a client keeps its picture after its last request for it: two seconds, in
    // frames of 8 ms.  After this time another client may take the memory of the picture.
    static const Uint32 FORGOTTEN_FRAMES = 250;

    int owner_;
    int layer_;
    Uint32 lastFrame_;  // frame of the owner's last request
    bool isHere_;
    CameraLayer kept_;  // the picture's layer; CameraLayer::bytes is not used
    Uint8 bytes_[RC_MAX_PICTURE];
};

#endif  // PictureSlot_h_DEFINED
