#include "Camera.h"

#include <OPENR/OFbkImage.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include <stdio.h>

static const char* const LOCATOR = "PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1";
static const char* const FILE_NAME = "/MS/OPEN-R/MW/DATA/P/PHOTO.PPM";

// Parameters of requests to the camera.
static const longword FLUORESCENT = 3;    // white balance, 4300 K
static const longword GAIN_0_DB = 2;      // the middle value of three
static const longword SHUTTER_10_MS = 2;  // 1/100 s

Camera::Camera() : camera_(oprimitiveID_UNDEF), numSeen_(0), rgb_(0), width_(0), height_(0) {}

OStatus
Camera::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;

    const OStatus status = OPENR::OpenPrimitive(LOCATOR, &camera_);
    if (status != oSUCCESS) {
        OSYSLOG1((osyslogERROR, "Camera: cannot open %s, status %u", LOCATOR, (unsigned)status));
        return oFAIL;
    }
    SetUp();
    return oSUCCESS;
}

OStatus
Camera::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Camera::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Camera::DoDestroy(const OSystemEvent&)
{
    delete[] rgb_;
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// Sets the camera up for a room with fluorescent lamps.
void
Camera::SetUp()
{
    OPrimitiveControl_CameraParam balance(FLUORESCENT);
    OPENR::ControlPrimitive(camera_, oprmreqCAM_SET_WHITE_BALANCE, &balance, sizeof(balance), 0,
                            0);
    OPrimitiveControl_CameraParam gain(GAIN_0_DB);
    OPENR::ControlPrimitive(camera_, oprmreqCAM_SET_GAIN, &gain, sizeof(gain), 0, 0);
    OPrimitiveControl_CameraParam shutter(SHUTTER_10_MS);
    OPENR::ControlPrimitive(camera_, oprmreqCAM_SET_SHUTTER_SPEED, &shutter, sizeof(shutter), 0,
                            0);
}

// Keeps asserting ready after our picture was taken, because an observer that stops asserting ready
// stalls the stream.
void
Camera::NotifyImage(const ONotifyEvent& event)
{
    OFbkImageVectorData* vector = (OFbkImageVectorData*)event.Data(0);
    if (++numSeen_ == NUM_SKIPPED + 1) {
        Convert(vector);
        OSYSPRINT(("Camera: a picture of %d x %d\n", width_, height_));
        if (WriteFile()) OSYSPRINT(("Camera: wrote %s\n", FILE_NAME));
    }
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

static byte
Clip(double value)
{
    return value < 0 ? 0 : value > 255 ? 255 : (byte)value;
}

// Converts luminance and two colour differences to red, green and blue.  Cr and Cb are bytes; 128
// stands for a difference of 0.  The last row of Y begins with 16 bytes of other data, so the row
// above is used for it.
void
Camera::Convert(OFbkImageVectorData* vector)
{
    OFbkImageInfo* info = vector->GetInfo(ofbkimageLAYER_H);
    byte* data = vector->GetData(ofbkimageLAYER_H);
    OFbkImage yImage(info, data, ofbkimageBAND_Y);
    OFbkImage crImage(info, data, ofbkimageBAND_Cr);
    OFbkImage cbImage(info, data, ofbkimageBAND_Cb);

    width_ = yImage.Width();
    height_ = yImage.Height();
    rgb_ = new byte[3 * width_ * height_];
    byte* out = rgb_;
    for (int row = 0; row < height_; row++) {
        const int yRow = row == height_ - 1 ? row - 1 : row;
        for (int x = 0; x < width_; x++) {
            const double y = yImage.Pixel(x, yRow);
            const double cr = crImage.Pixel(x, row) - 128;
            const double cb = cbImage.Pixel(x, row) - 128;
            *out++ = Clip(y + cr);
            *out++ = Clip(y - 0.51 * cr - 0.19 * cb);
            *out++ = Clip(y + cb);
        }
    }
}

// Writes a PPM file: a line of text, then the bytes of the pixels.
bool
Camera::WriteFile() const
{
    const size_t size = 3 * width_ * height_;
    FILE* file = fopen(FILE_NAME, "wb");
    bool isGood = file != 0 && fprintf(file, "P6 %d %d 255\n", width_, height_) > 0 &&
                  fwrite(rgb_, 1, size, file) == size;
    if (file != 0 && fclose(file) != 0) isGood = false;
    if (!isGood) OSYSLOG1((osyslogERROR, "Camera: cannot write %s", FILE_NAME));
    return isGood;
}
