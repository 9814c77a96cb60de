// The protocols that antEnvCreateEndpointMsg can name for a new endpoint.  Headers with messages
// exist for endpoints of TCP, UDP, DNS and IP; the other protocols are only numbers here.
#ifndef OPENR_ENDPOINTTYPES_H_INCLUDED
#define OPENR_ENDPOINTTYPES_H_INCLUDED

#include <antTypes.h>

const int32 EndpointType_TCP = 1;
const int32 EndpointType_UDP = 2;
const int32 EndpointType_TFTP = 3;
const int32 EndpointType_DNS = 4;
const int32 EndpointType_POP3 = 5;
const int32 EndpointType_SMTP = 6;
const int32 EndpointType_IP = 7;
const int32 EndpointType_MIBII = 8;
const int32 EndpointType_MIB_ETHERNET = 9;

#endif  // OPENR_ENDPOINTTYPES_H_INCLUDED
