#ifndef DEVICE_TYPES_H
#define DEVICE_TYPES_H

/* Names a device; 0 is none. */
typedef unsigned short DeviceTag;

#endif /* DEVICE_TYPES_H */
