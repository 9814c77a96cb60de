#ifndef DEVICE_TYPES_H
#define DEVICE_TYPES_H

/* The number (tag) of a device; 0 means no device. */
typedef unsigned short DeviceTag;

#endif /* DEVICE_TYPES_H */
