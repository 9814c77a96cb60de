/*
 * The camera of the head (wished for in Hohl 2004, section 5.5), with the functions of Webots.
 *
 * An image is stored row by row from the top left; a pixel has three bytes: red, green, blue.
 */

#ifndef DEVICE_CAMERA_H
#define DEVICE_CAMERA_H

#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* camera_enable() switches images on, camera_disable() off.  `ms` is ignored: there are always 25
 * images a second.  Images need 76 KB of memory. */
void camera_enable(DeviceTag camera, unsigned short ms);
void camera_disable(DeviceTag camera);

/* The next two functions return the size of an image in pixels: 176 x 144 on the ERS-210; 0 for
 * other devices. */
unsigned short camera_get_width(DeviceTag camera);
unsigned short camera_get_height(DeviceTag camera);

/* Returns the field of view from left to right, in radians. */
float camera_get_fov(DeviceTag camera);

/*
 * Returns the newest image; null before the first image, while images are switched off, and for
 * other devices.  The next image is written to the same memory, between two calls of the run
 * function.
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
