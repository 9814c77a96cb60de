#include "kit/image_match.h"

#include <algorithm>
#include <cctype>
#include <functional>

namespace openr_host {
namespace {

// Least length of the two names that IsPrefix() and IsPart() compare, and of the wanted name in
// IsLongSubsequence().  A shorter name may occur in another name by chance.
constexpr size_t kLeastLength = 3;
// Least number of letters in a row that two names must share before HaveCommonPart() takes them for
// names of the same image.
constexpr size_t kLeastSharedLetters = 4;

// Returns the letters and digits of an image's name in lower case, without the extension.
std::string Normalised(const std::string& name) {
  std::string result;
  for (const char c : name.substr(0, name.rfind('.'))) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0) result += static_cast<char>(std::tolower(byte));
  }
  return result;
}

bool IsPrefix(const std::string& wanted, const std::string& name) {
  if (std::min(wanted.size(), name.size()) < kLeastLength) return false;
  return name.starts_with(wanted) || wanted.starts_with(name);
}

bool IsSubsequence(const std::string& wanted, const std::string& name) {
  size_t found = 0;
  for (const char c : name) found += found < wanted.size() && wanted[found] == c;
  return !wanted.empty() && found == wanted.size();
}

bool IsSubsequenceFromTheFirst(const std::string& wanted, const std::string& name) {
  return !wanted.empty() && !name.empty() && wanted[0] == name[0] && IsSubsequence(wanted, name);
}

bool IsPart(const std::string& wanted, const std::string& name) {
  if (std::min(wanted.size(), name.size()) < kLeastLength) return false;
  return name.find(wanted) != std::string::npos || wanted.find(name) != std::string::npos;
}

bool IsLongSubsequence(const std::string& wanted, const std::string& name) {
  return wanted.size() >= kLeastLength && IsSubsequence(wanted, name);
}

// Returns whether the two names have kLeastSharedLetters letters in a row in common, as "mywalker"
// and "walking" have "walk".
bool HaveCommonPart(const std::string& wanted, const std::string& name) {
  for (size_t at = 0; at + kLeastSharedLetters <= wanted.size(); ++at) {
    if (name.find(wanted.substr(at, kLeastSharedLetters)) != std::string::npos) return true;
  }
  return false;
}

class Matcher {
 public:
  Matcher(const std::vector<std::string>& wanted, const std::vector<ImageCandidate>& candidates)
      : result_(wanted.size(), -1), is_taken_(candidates.size(), false) {
    for (const std::string& name : wanted) wanted_.push_back(Normalised(name));
    for (const ImageCandidate& candidate : candidates) {
      std::vector<std::string>& names = names_.emplace_back();
      for (const std::string& name : candidate.names) names.push_back(Normalised(name));
    }
  }

  // Applies the rule `fits`, which compares names, to the names in OBJECT.CFG that have no image
  // yet.  Pairs such a name with a built image (a candidate) if, by this rule, the name fits only
  // this image and the image fits only this name.
  void Pair(const std::function<bool(const std::string& wanted, const std::string& name)>& fits) {
    for (size_t w = 0; w < wanted_.size(); ++w) {
      const int only = OnlyCandidate(w, fits);
      if (only < 0) continue;
      size_t rivals = 0;
      for (size_t other = 0; other < wanted_.size(); ++other)
        rivals += result_[other] < 0 && Fits(other, static_cast<size_t>(only), fits);
      if (rivals > 1) continue;
      result_[w] = only;
      is_taken_[static_cast<size_t>(only)] = true;
    }
  }

  const std::vector<int>& result() const { return result_; }

 private:
  using Test = std::function<bool(const std::string&, const std::string&)>;

  bool Fits(size_t wanted, size_t candidate, const Test& fits) const {
    return std::any_of(names_[candidate].begin(), names_[candidate].end(),
                       [&](const std::string& name) { return fits(wanted_[wanted], name); });
  }

  int OnlyCandidate(size_t wanted, const Test& fits) const {
    int only = -1;
    if (result_[wanted] >= 0) return -1;
    for (size_t c = 0; c < names_.size(); ++c) {
      if (is_taken_[c] || !Fits(wanted, c, fits)) continue;
      if (only >= 0) return -1;
      only = static_cast<int>(c);
    }
    return only;
  }

  std::vector<std::string> wanted_;
  std::vector<std::vector<std::string>> names_;
  std::vector<int> result_;
  std::vector<bool> is_taken_;
};

}  // namespace

std::vector<int> MatchImages(const std::vector<std::string>& wanted,
                             const std::vector<ImageCandidate>& candidates) {
  Matcher matcher(wanted, candidates);
  // Applies strict rules before loose ones, so that a loose rule is asked only about names that no
  // strict rule could pair.
  matcher.Pair([](const std::string& a, const std::string& b) { return a == b; });
  matcher.Pair(&IsPrefix);
  matcher.Pair(&IsSubsequenceFromTheFirst);
  matcher.Pair(&IsPart);
  matcher.Pair(&IsLongSubsequence);
  matcher.Pair(&HaveCommonPart);
  matcher.Pair([](const std::string&, const std::string&) { return true; });
  return matcher.result();
}

std::string ShortImageName(const std::string& name) {
  std::string result;
  // Adds a dot to the name, because Normalised() removes everything from the last dot on as an
  // extension.
  for (const char c : Normalised(name + ".")) {
    if (result.size() < 8) result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return (result.empty() ? "OBJECT" : result) + ".BIN";
}

}  // namespace openr_host
