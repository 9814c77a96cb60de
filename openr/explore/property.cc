#include "openr/explore/property.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "openr/explore/property_file.h"
#include "runtime/base/spelling.h"
#include "runtime/core/run_end.h"
#include "runtime/core/stalls.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

class NoFindings : public Property {
 public:
  NoFindings(const char* name, bool warnings_too) : Property(name), warnings_too_(warnings_too) {}

  std::string Check(const RunView& view) override {
    const auto& findings = view.prepared->system->findings().all();
    for (; seen_ < findings.size(); ++seen_) {
      const Finding& finding = findings[seen_];
      const bool is_warning = finding.severity == Severity::kWarning && warnings_too_;
      if (finding.severity != Severity::kError && !is_warning) continue;
      const std::string about = finding.object.empty() ? "" : finding.object + ": ";
      return fmt::format("{}: {}{} (message {})", SeverityName(finding.severity), about,
                         finding.text, finding.message);
    }
    return "";
  }

 private:
  const bool warnings_too_;
  size_t seen_ = 0;
};

class NoDrops : public Property {
 public:
  NoDrops() : Property("no-drops") {}

  std::string Check(const RunView& view) override {
    for (const auto& object : view.prepared->system->objects()) {
      if (object->is_system() || object->statistics().dropped_count() == 0) continue;
      return fmt::format("{}: data were replaced before they were read, or messages refused",
                         object->name);
    }
    return "";
  }
};

class NotFallen : public Property {
 public:
  NotFallen() : Property("not-fallen") {}

  std::string Check(const RunView& view) override {
    // The smallest cosine of the tilt of an upright robot, which is tilted by at most 45 degrees.
    constexpr double kUprightMin = 0.7071;
    has_stood_.resize(view.prepared->robots.size());
    for (size_t i = 0; i < has_stood_.size(); ++i) {
      if ((*view.standing)[i].standing()) has_stood_[i] = true;
      const BodyState& state = view.prepared->robots[i]->body().state();
      if (!has_stood_[i] || state.X_WB.linear()(2, 2) > kUprightMin) continue;
      return fmt::format("robot {} has stood, and leans more than 45 degrees now", i);
    }
    return "";
  }

 private:
  std::vector<bool> has_stood_;
};

class Standing : public Property {
 public:
  Standing() : Property("standing") {}

  std::string CheckEnd(const RunView& view) override {
    for (size_t i = 0; i < view.standing->size(); ++i) {
      if (!(*view.standing)[i].standing()) return fmt::format("robot {} does not stand", i);
    }
    return "";
  }
};

class EveryReadyAnswered : public Property {
 public:
  EveryReadyAnswered() : Property("every-ready-answered") {}

  std::string CheckEnd(const RunView& view) override {
    for (const Stall& stall : FindStalls(*view.prepared->system, kStallUs)) {
      if (!stall.may_be_done) return fmt::format("{}; {}", stall.text, stall.advice);
    }
    return "";
  }
};

class NotStuck : public Property {
 public:
  NotStuck() : Property("not-stuck") {}

  std::string CheckEnd(const RunView& view) override {
    const System& system = *view.prepared->system;
    if (system.powered_off() || system.now_us() - view.last_activity_us < kStallUs) return "";
    const auto stalls = FindStalls(system, kStallUs);
    if (stalls.empty()) return "";
    return fmt::format(
        "nobody has sent anything but sensor values and readies for them since t={:.3f} s, and {}",
        static_cast<double>(view.last_activity_us) * 1e-6, stalls[0].text);
  }
};

template <typename T>
std::unique_ptr<Property> Make() {
  return std::make_unique<T>();
}

const PropertyEntry* FindEntry(const std::string& name) {
  for (const PropertyEntry& entry : PropertyTable()) {
    if (name == entry.name) return &entry;
  }
  return nullptr;
}

std::vector<std::string> KnownNames() {
  std::vector<std::string> names = {"default"};
  for (const PropertyEntry& entry : PropertyTable()) names.push_back(entry.name);
  return names;
}

}  // namespace

const char* PropertyOfEnding(std::string_view ended_by) {
  return ended_by == EndName(EndKind::kHandlerLimit) ? kHandlersReturn : kNoCrash;
}

const std::vector<PropertyEntry>& PropertyTable() {
  static const std::vector<PropertyEntry> table = {
      {"no-errors", "no finding is an error", true,
       [] { return std::unique_ptr<Property>(new NoFindings("no-errors", false)); }},
      {"no-warnings", "there is no finding at all", false,
       [] { return std::unique_ptr<Property>(new NoFindings("no-warnings", true)); }},
      {"no-drops", "no object of the stick loses data or a message", true, &Make<NoDrops>},
      {"not-fallen", "a robot that has stood leans 45 degrees at most", true, &Make<NotFallen>},
      {"standing", "every robot stands at the end", false, &Make<Standing>},
      {"not-stuck", "the graph does not fall silent while somebody waits", true, &Make<NotStuck>},
      {"every-ready-answered",
       "at the end nothing has waited for 1 s: data for a ready, a call for its answer, a handler "
       "for the processor",
       true, &Make<EveryReadyAnswered>},
  };
  return table;
}

std::vector<std::unique_ptr<Property>> PropertyChoice::Make() const {
  std::vector<std::unique_ptr<Property>> properties;
  for (const std::string& name : names) {
    if (const PropertyEntry* const entry = FindEntry(name)) {
      properties.push_back(entry->make());
    } else if (name == "default") {
      for (const PropertyEntry& each : PropertyTable()) {
        if (each.by_default) properties.push_back(each.make());
      }
    } else if (name.find(' ') != std::string::npos) {  // `name` is a line as in a property file
      for (auto& property : MakeProperties("--property", name)) {
        properties.push_back(std::move(property));
      }
    } else if (std::error_code error; std::filesystem::is_regular_file(name, error)) {
      for (auto& property : LoadPropertyFile(name)) {
        properties.push_back(std::move(property));
      }
    } else {
      throw std::runtime_error(
          fmt::format("'{}' is neither a property nor a file of properties (docs/exploring.md){}",
                      name, DidYouMean(name, KnownNames())));
    }
  }
  return properties;
}

}  // namespace openr_host
