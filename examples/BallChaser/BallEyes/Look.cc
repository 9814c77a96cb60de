#include "Look.h"

#include "Maths.h"

// The neck and the camera, in mm in the dog's own frame (Model Information ERS-210, 1.2).  The
// tilt turns everything above TILT_Z, then the pan turns the head around an axis NECK above that.
static const double TILT_X = 75;
static const double TILT_Z = 50;
static const double NECK = 48;
static const double LENS_AHEAD = 66.6;

// Half of the camera's field of view is 28.8 degrees wide and 23.9 high.  A lens draws the
// tangent.
static const double TAN_HALF_WIDTH = 0.54975;
static const double TAN_HALF_HEIGHT = 0.44314;

static const double MIDDLE_HEIGHT = 98;  // the dog's middle above the floor, while it walks
static const double FARTHEST = 5000;

Look::Look(double tilt, double pan, int width, int height)
    : cosTilt_(Cos(tilt)), sinTilt_(Sin(tilt)), cosPan_(Cos(pan)), sinPan_(Sin(pan)),
      width_(width), height_(height)
{
    const double ahead = LENS_AHEAD * cosPan_;
    lens_.x = TILT_X + ahead * cosTilt_ - NECK * sinTilt_;
    lens_.y = LENS_AHEAD * sinPan_;
    lens_.z = TILT_Z + ahead * sinTilt_ + NECK * cosTilt_;
}

Ray
Look::RayOf(double pixelX, double pixelY) const
{
    const double left = (1 - 2 * pixelX / width_) * TAN_HALF_WIDTH;
    const double up = (1 - 2 * pixelY / height_) * TAN_HALF_HEIGHT;
    const double ahead = cosPan_ - left * sinPan_;
    Ray ray;
    ray.x = ahead * cosTilt_ - up * sinTilt_;
    ray.y = sinPan_ + left * cosPan_;
    ray.z = ahead * sinTilt_ + up * cosTilt_;
    return ray;
}

bool
Look::FindPlace(const Ray& ray, double height, double* x, double* y) const
{
    const double down = MIDDLE_HEIGHT + lens_.z - height;
    if (-ray.z * FARTHEST < down) return false;
    *x = lens_.x + ray.x * down / -ray.z;
    *y = lens_.y + ray.y * down / -ray.z;
    return true;
}
