// EntryNames: the names of an object's entries, for traces and messages to users.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

namespace openr_host {

class EntryNames {
 public:
  using Names = std::map<uint32_t, std::string>;  // the key is the selector of the entry

  // Gives entry `selector` a name, which replaces its earlier name.
  void SetName(uint32_t selector, std::string name) { names_[selector] = std::move(name); }
  // Records the full name of the service that was registered for entry `selector`.
  void SetService(uint32_t selector, std::string service) {
    services_[selector] = std::move(service);
  }

  // Returns the name that SetName() has given to entry `selector`; null if it has given none.
  // Takes no memory, so that a signal handler may call this function.
  const std::string* FindName(uint32_t selector) const { return Find(names_, selector); }
  // Returns the full name of the service that was registered for entry `selector`; null if there is
  // no such service.  Takes no memory, so that a signal handler may call this function.
  const std::string* FindService(uint32_t selector) const { return Find(services_, selector); }
  // Returns a text for every selector: "DoStart", "Mover (Notify)", "selector 12".
  std::string TextOf(uint32_t selector) const;

  const Names& names() const { return names_; }  // the names that SetName() has given

 private:
  static const std::string* Find(const Names& names, uint32_t selector) {
    const auto found = names.find(selector);
    return found == names.end() ? nullptr : &found->second;
  }

  Names names_;
  Names services_;
};

}  // namespace openr_host
