// Protocol and port numbers of the Internet.
//
// The names are macros of the host's <netinet/in.h> as well, so do not include both headers in one
// source.
#ifndef OPENR_INTERNET_H_INCLUDED
#define OPENR_INTERNET_H_INCLUDED

#define IPPROTO_IP 0
#define IPPROTO_ICMP 1
#define IPPROTO_IGMP 2
#define IPPROTO_GGP 3
#define IPPROTO_TCP 6
#define IPPROTO_EGP 8
#define IPPROTO_PUP 12
#define IPPROTO_UDP 17
#define IPPROTO_IDP 22
#define IPPROTO_TP 29
#define IPPROTO_EON 80
#define IPPROTO_ENCAP 98
#define IPPROTO_RAW 255
#define IPPROTO_MAX 256

#define IPPORT_RESERVED 1024      // ports below this number are for system services
#define IPPORT_USERRESERVED 5000  // ports that the network stack chooses are below this number

#endif  // OPENR_INTERNET_H_INCLUDED
