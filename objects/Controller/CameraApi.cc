//
// Implements the functions of include/device/camera.h.
//

#include <device/camera.h>

#include <vector>

#include "ControllerApi.h"

static std::vector<Uint8> theImage;  // the newest image; empty while the camera is disabled
static bool theImageIsThere = false;

static const CameraConstants*
CameraOf(DeviceTag tag)
{
    ControllerCore* core = GetControllerCore();
    return core != 0 && core->Devices().IsCamera(tag) ? &core->Robot()->camera : 0;
}

void
camera_enable(DeviceTag tag, unsigned short)
{
    const CameraConstants* camera = CameraOf(tag);
    if (camera == 0 || !theImage.empty()) return;
    theImage.resize(3 * camera->width * camera->height);
    GetControllerCore()->Port()->EnableCamera(true);
}

void
camera_disable(DeviceTag tag)
{
    if (CameraOf(tag) == 0 || theImage.empty()) return;
    // Swaps with an empty vector, because clear() would keep the memory of the image (76 KB).
    std::vector<Uint8>().swap(theImage);
    theImageIsThere = false;
    GetControllerCore()->Port()->EnableCamera(false);
}

unsigned short
camera_get_width(DeviceTag tag)
{
    const CameraConstants* camera = CameraOf(tag);
    return camera != 0 ? (unsigned short)camera->width : 0;
}

unsigned short
camera_get_height(DeviceTag tag)
{
    const CameraConstants* camera = CameraOf(tag);
    return camera != 0 ? (unsigned short)camera->height : 0;
}

float
camera_get_fov(DeviceTag tag)
{
    const CameraConstants* camera = CameraOf(tag);
    return camera != 0 ? (float)(camera->fovUrad * 1e-6) : 0.0f;
}

unsigned char*
camera_get_image(DeviceTag tag)
{
    return CameraOf(tag) != 0 && theImageIsThere ? &theImage[0] : 0;
}

Uint8*
CameraBuffer()
{
    if (theImage.empty()) return 0;
    theImageIsThere = true;
    return &theImage[0];
}
