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

/* Switches images on, 25 a second for every `ms`, and off.  Images need 76 KB of memory. */
void camera_enable(DeviceTag camera, unsigned short ms);
void camera_disable(DeviceTag camera);

/* Size in pixels: 176 x 144 on the ERS-210; 0 for other devices. */
unsigned short camera_get_width(DeviceTag camera);
unsigned short camera_get_height(DeviceTag camera);

/* Field of view from left to right, radians. */
float camera_get_fov(DeviceTag camera);

/*
 * The newest image; null before the first one, while disabled and for other devices.  The next
 * image is written to the same memory, between two calls of the run function.
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
