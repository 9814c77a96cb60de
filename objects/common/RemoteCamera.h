//
// Pictures of the camera over the remote control (version 2, docs/remote-control.md).
//

#ifndef RemoteCamera_h_DEFINED
#define RemoteCamera_h_DEFINED

#include "FixedTypes.h"
#include "RemotePacket.h"

// Layers of a picture: H, M and L have luminance and colours in three sizes, C has the colours that
// were detected.  The numbers are those of the SDK (ofbkimageLAYER_H and so on).
const int NUM_RC_LAYERS = 4;

// Size of the largest layer of a camera's image on any robot, in bytes.  It is the layer with the
// full resolution of the ERS-7, which consists of six bands of 208 x 160 pixels.
const Uint32 RC_MAX_PICTURE = 6 * 208 * 160;

// The head of an answer to CAMERA_PART, the request for a part of a picture.  The bytes of the part
// follow this head.
struct RcPicturePart {
    Uint16 part;    // number of the part, from 0
    Uint16 parts;   // number of parts of the picture
    Uint32 frame;   // frame number of the picture
    Uint8 layer;
    Uint8 bands;    // bands of each row: Y, Cr, Cb, LH, HL, HH, or only Y, Cr, Cb; 1 for layer C
    Uint16 width;   // in pixels
    Uint16 height;

    static const int SIZE = 14;

    void Write(RcWriter* out) const;
    // Reads the members above, but not the bytes of the picture that follow them.
    void Read(RcReader* in);
};

// Largest number of bytes of a layer that an answer to CAMERA_PART can carry.  All parts but the
// last have this size.
const int RC_MAX_PICTURE_DATA = RC_MAX_PACKET - RC_ANSWER_HEADER_SIZE - RcPicturePart::SIZE;

#endif  // RemoteCamera_h_DEFINED
