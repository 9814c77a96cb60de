// Declares Dds(), which returns the functions of Cyclone DDS that this program calls.
//
// The library is loaded by the first call of Dds() and not at the start of the program.  Most runs
// have only one process and need no DDS.  At the start, loading the library with OpenSSL and
// iceoryx would take a fifth of the time of the start (docs/performance.md, "The start of a run").
#pragma once

#include <dds/dds.h>
#include <dds/ddsrt/environ.h>
#include <dds/ddsrt/heap.h>
#include <dds/ddsrt/xmlparser.h>

namespace openr_host {

// Calls F(name) for each function of Cyclone DDS that this program uses.
// clang-format off
#define OPENR_DDS_FUNCTIONS(F)                                                                   \
  F(dds_alloc) F(dds_builtintopic_free_endpoint) F(dds_create_domain) F(dds_create_participant)  \
  F(dds_create_publisher) F(dds_create_qos) F(dds_create_readcondition) F(dds_create_reader)     \
  F(dds_create_subscriber) F(dds_create_topic) F(dds_create_waitset) F(dds_create_writer)        \
  F(dds_delete) F(dds_delete_qos) F(dds_free) F(dds_get_matched_publication_data)                \
  F(dds_get_matched_publications) F(dds_get_publication_matched_status)                          \
  F(dds_get_requested_incompatible_qos_status) F(dds_get_subscription_matched_status)            \
  F(dds_qget_userdata) F(dds_qset_data_representation) F(dds_qset_durability)                    \
  F(dds_qset_history) F(dds_qset_ignorelocal) F(dds_qset_liveliness) F(dds_qset_partition)       \
  F(dds_qset_reliability) F(dds_qset_resource_limits) F(dds_qset_userdata) F(dds_return_loan)    \
  F(dds_sample_free) F(dds_set_log_sink) F(dds_strretcode) F(dds_take) F(dds_wait_for_acks)      \
  F(dds_waitset_attach) F(dds_waitset_wait) F(dds_write) F(dds_write_flush)                      \
  F(dds_write_set_batch) F(ddsrt_expand_envvars) F(ddsrt_free) F(ddsrt_xmlp_free)                \
  F(ddsrt_xmlp_new_file) F(ddsrt_xmlp_parse)
// clang-format on

// Pointers to the functions of Cyclone DDS; each member has the name of its function.
struct DdsFunctions {
// dds_write_set_batch() is deprecated since version 0.10.5.  We still use it, because Debian 12 has
// version 0.10.2, which lacks the successor dds_qset_writer_batching().
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
#define OPENR_DDS_POINTER(name) decltype(&::name) name;
  OPENR_DDS_FUNCTIONS(OPENR_DDS_POINTER)
#undef OPENR_DDS_POINTER
#pragma GCC diagnostic pop
};

// Returns the functions of Cyclone DDS; the first call loads the library.  Throws
// std::runtime_error if the library cannot be loaded.
const DdsFunctions& Dds();

}  // namespace openr_host
