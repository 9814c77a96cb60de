#include "distribution/dds_settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <strings.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "distribution/dds.h"

namespace openr_host {
namespace {

bool IsSame(const char* name, const char* other) { return strcasecmp(name, other) == 0; }

// An XML element <Domain> of the user's settings file for Cyclone DDS.  The settings in the element
// are for one DDS domain, or for all domains if `id` is "any".
struct DomainElement {
  std::string id = "any";
  bool has_security = false;

  // Returns whether the element applies to `domain`.  Compares ids in the same way as Cyclone DDS,
  // so that the result is true exactly if Cyclone DDS will use the element.
  bool IsFor(int domain) const {
    if (IsSame(id.c_str(), "any")) return true;
    char* end = nullptr;
    const long number = std::strtol(id.c_str(), &end, 10);
    return *end == '\0' && end != id.c_str() && number == domain;
  }
};

// Reads the user's settings file for Cyclone DDS with the XML parser of Cyclone DDS and keeps its
// <Domain> elements.
class SettingsFile {
 public:
  SettingsFile(const std::string& name, int domain) : domain_(domain) {
    const std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(name.c_str(), "r"), &std::fclose);
    if (file == nullptr) return;
    const ddsrt_xmlp_callbacks callbacks = {&Open, &Attribute, &Data, &Close, &Error};
    ddsrt_xmlp_state* const parser = Dds().ddsrt_xmlp_new_file(file.get(), this, &callbacks);
    is_read_ = Dds().ddsrt_xmlp_parse(parser) >= 0;
    Dds().ddsrt_xmlp_free(parser);
  }

  bool is_read() const { return is_read_; }
  // Returns whether the settings file of Cyclone DDS has settings outside <Domain>.  Files for
  // older versions of Cyclone DDS have such settings, which apply to all domains.
  bool has_others() const { return has_others_; }
  const std::vector<DomainElement>& domains() const { return domains_; }

 private:
  enum Element : uintptr_t { kNone, kRoot, kDomain, kDomainId, kOther };

  static int Open(void* self, uintptr_t parent, uintptr_t* element, const char* name, int) {
    auto* const file = static_cast<SettingsFile*>(self);
    *element = kOther;
    if (parent == kNone) *element = kRoot;
    if (parent == kRoot && IsSame(name, "Domain")) {
      *element = kDomain;
      file->domains_.emplace_back();
    } else if (parent == kRoot) {
      file->has_others_ = true;
    } else if (parent == kDomain && IsSame(name, "Id")) {
      // Accepts an element <Id>, because settings files for older versions of Cyclone DDS give the
      // id of a DDS domain in this element.  Newer files give the id in an attribute of <Domain>.
      *element = kDomainId;
    } else if (parent == kDomain && (IsSame(name, "Security") || IsSame(name, "DDSSecurity"))) {
      file->domains_.back().has_security = true;
    }
    return 1;
  }
  static int Attribute(void* self, uintptr_t element, const char* name, const char* value, int) {
    if (element == kDomain && IsSame(name, "id")) static_cast<SettingsFile*>(self)->SetId(value);
    return 1;
  }
  static int Data(void* self, uintptr_t element, const char* data, int) {
    if (element == kDomainId) static_cast<SettingsFile*>(self)->SetId(data);
    return 1;
  }
  static int Close(void*, uintptr_t, int) { return 1; }
  static void Error(void*, const char*, int) {}

  void SetId(const char* text) {
    // Replaces environment variables in the id, such as "${DOMAIN}", by their values, because
    // Cyclone DDS does the same.
    char* const id = Dds().ddsrt_expand_envvars(text, static_cast<uint32_t>(domain_));
    if (id != nullptr) domains_.back().id = id;
    Dds().ddsrt_free(id);
  }

  const int domain_;
  bool is_read_ = false;
  bool has_others_ = false;
  std::vector<DomainElement> domains_;
};

}  // namespace

std::string DomainProblem(const std::string& file, int domain) {
  const SettingsFile settings(file, domain);
  if (!settings.is_read()) return "";
  bool applies = settings.has_others(), protects = false;
  std::vector<std::string> left_out, not_protected;
  for (const DomainElement& element : settings.domains()) {
    const bool is_for = element.IsFor(domain);
    applies = applies || is_for;
    protects = protects || (is_for && element.has_security);
    if (!is_for) left_out.push_back(element.id);
    if (!is_for && element.has_security) not_protected.push_back(element.id);
  }
  const std::string advice = "write <Domain id=\"any\">, or give --dds-domain";
  if (!applies && left_out.empty()) return "there are no settings in it";
  if (!applies)
    return fmt::format(
        "its settings are for domain {}, this is domain {}: they would be left out; {}",
        fmt::join(left_out, ", "), domain, advice);
  if (!protects && !not_protected.empty())
    return fmt::format(
        "its <Security> is for domain {}, this is domain {}, which would not be protected; {}",
        fmt::join(not_protected, ", "), domain, advice);
  return "";
}

}  // namespace openr_host
