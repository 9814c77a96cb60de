#include "PictureSlot.h"

#include <string.h>

void
PictureSlot::Reserve(int client, int layer, Uint32 frame)
{
    owner_ = client;
    layer_ = layer;
    lastFrame_ = frame;
    isHere_ = false;
}

// Stores a copy of `layer`.  Cuts off the end of a layer that is larger than all layers of known
// robots, because the memory has a fixed size.
void
PictureSlot::Put(const CameraLayer& layer)
{
    kept_ = layer;
    if (kept_.size > RC_MAX_PICTURE) kept_.size = RC_MAX_PICTURE;
    if (kept_.size > 0) memcpy(bytes_, layer.bytes, kept_.size);
    isHere_ = true;
}

int
PictureSlot::NumParts() const
{
    return (int)((kept_.size + RC_MAX_PICTURE_DATA - 1) / RC_MAX_PICTURE_DATA);
}

void
PictureSlot::WritePart(int part, RcWriter* out) const
{
    const Uint32 pixels = (Uint32)kept_.width * kept_.height;
    RcPicturePart head;
    head.part = (Uint16)part;
    head.parts = (Uint16)NumParts();
    head.frame = kept_.frame;
    head.layer = (Uint8)layer_;
    head.bands = (Uint8)(pixels > 0 ? kept_.size / pixels : 0);
    head.width = kept_.width;
    head.height = kept_.height;
    head.Write(out);
    const Uint32 at = (Uint32)part * RC_MAX_PICTURE_DATA;
    const Uint32 rest = kept_.size - at;
    out->Bytes(bytes_ + at, (int)(rest < (Uint32)RC_MAX_PICTURE_DATA ? rest : RC_MAX_PICTURE_DATA));
}
