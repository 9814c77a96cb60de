/*
 * The camera of the head (wished for in Hohl 2004, section 5.5), with the functions of Webots.
 *
 * An image is rows of pixels from the top left, three bytes each: red, green, blue.
 */

#ifndef DEVICE_CAMERA_H
#define DEVICE_CAMERA_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Images come, 25 a second whatever `ms`, until they are disabled.  It takes 76 KB of memory. */
void camera_enable(DeviceTag camera, unsigned short ms);
void camera_disable(DeviceTag camera);

/* Pixels: 176 and 144 on the ERS-210; 0 for anything that is no camera. */
unsigned short camera_get_width(DeviceTag camera);
unsigned short camera_get_height(DeviceTag camera);

/* Radians, from left to right. */
float camera_get_fov(DeviceTag camera);

/*
 * The newest image; null before the first one, when disabled and for anything that is no camera.
 * The next one is written to the same place, between two calls of the run function.
 */
unsigned char *camera_get_image(DeviceTag camera);

#ifdef __cplusplus
}
#endif

#define camera_image_get_red(image, width, x, y) ((image)[3 * ((y) * (width) + (x))])
#define camera_image_get_green(image, width, x, y) ((image)[3 * ((y) * (width) + (x)) + 1])
#define camera_image_get_blue(image, width, x, y) ((image)[3 * ((y) * (width) + (x)) + 2])
#define camera_image_get_grey(image, width, x, y)                                        \
    ((camera_image_get_red(image, width, x, y) + camera_image_get_green(image, width, x, y) + \
      camera_image_get_blue(image, width, x, y)) / 3)

#endif /* DEVICE_CAMERA_H */
