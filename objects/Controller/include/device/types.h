#ifndef DEVICE_TYPES_H
#define DEVICE_TYPES_H

/* The number of a device; 0 is no device. */
typedef unsigned short DeviceTag;

#endif /* DEVICE_TYPES_H */
