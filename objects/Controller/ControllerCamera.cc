//
// Gives camera images to the controller: converts their pixels from YCrCb (luminance and two colour
// differences) to red, green and blue.
//

#include "Controller.h"

#include <OPENR/OFbkImage.h>

#include "ControllerApi.h"

// Switches the reception of images on or off by asserting or deasserting ready, because images are
// sent only to an observer that is ready.
void
Controller::EnableCamera(bool on)
{
    isCameraOn_ = on;
    if (on) {
        observer[obsImage]->AssertReady();
    } else {
        observer[obsImage]->DeassertReady();
    }
}

static Uint8
Clip(int value)
{
    return (Uint8)(value < 0 ? 0 : (value > 255 ? 255 : value));
}

// Converts the image with integers, so that every compiler gives the same picture.  Y is the
// luminance, Cr is red - Y, and Cb is blue - Y.  So red is Y + Cr, blue is Y + Cb, and green is Y -
// 0.51 Cr - 0.19 Cb.  The last row of Y begins with 16 bytes of other data, so for this row the Y
// of the row above is used.
static void
Convert(OFbkImageVectorData* vector, int width, int height, Uint8* out)
{
    OFbkImageInfo* info = vector->GetInfo(ofbkimageLAYER_H);
    byte* data = vector->GetData(ofbkimageLAYER_H);
    OFbkImage yImage(info, data, ofbkimageBAND_Y);
    OFbkImage crImage(info, data, ofbkimageBAND_Cr);
    OFbkImage cbImage(info, data, ofbkimageBAND_Cb);
    if (yImage.Width() != width || yImage.Height() != height) return;
    for (int row = 0; row < height; row++) {
        const int yRow = row == height - 1 ? row - 1 : row;
        for (int x = 0; x < width; x++) {
            const int y = yImage.Pixel(x, yRow);
            const int cr = crImage.Pixel(x, row) - 128;
            const int cb = cbImage.Pixel(x, row) - 128;
            *out++ = Clip(y + cr);
            // Computes green as y - 0.51 cr - 0.19 cb: 131 / 256 is 0.51, and 49 / 256 is 0.19.
            // 128 x 256 makes the dividend positive, because C++98 leaves open how a negative
            // quotient is rounded.  This makes the quotient greater by 128, so 128 is added to y,
            // too.  The 128 at the end of the dividend rounds the quotient to the nearest.
            *out++ = Clip(y + 128 - (131 * cr + 49 * cb + 128 * 256 + 128) / 256);
            *out++ = Clip(y + cb);
        }
    }
}

void
Controller::NotifyImage(const ONotifyEvent& event)
{
    if (!isCameraOn_) return;  // ignores an image that was sent before the camera was disabled
    Uint8* out = CameraBuffer();
    if (out != 0) {
        OFbkImageVectorData* vector = (OFbkImageVectorData*)event.Data(event.NumOfData() - 1);
        Convert(vector, robot_->camera.width, robot_->camera.height, out);
    }
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}
