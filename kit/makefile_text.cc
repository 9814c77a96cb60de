#include "kit/makefile_text.h"

#include <algorithm>
#include <regex>

#include "kit/sdk_paths.h"

namespace openr_host {
namespace {

using Names = std::vector<std::string>;

void AddOnce(const std::string& name, Names* names) {
  if (std::find(names->begin(), names->end(), name) == names->end()) names->push_back(name);
}

// Returns the texts that the group `group` of `pattern` matches in `text`, each once.
Names AllMatches(const std::string& text, const std::regex& pattern, size_t group = 1) {
  Names names;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
    if ((*it)[group].matched) AddOnce((*it)[group], &names);
  }
  return names;
}

std::string Escaped(const std::string& literal) {
  std::string pattern;
  for (const char c : literal) {
    if (std::string_view("^$\\.*+?()[]{}|").find(c) != std::string_view::npos) pattern += '\\';
    pattern += c;
  }
  return pattern;
}

MakefileVariable Describe(const std::string& name, const std::string& text) {
  MakefileVariable variable{name, false, {}, ""};
  const std::regex assignment("(?:^|\n)[ \t]*(?:export[ \t]+)?" + name +
                              "[ \t]*[:?+]?=[ \t]*([^#\n]*)");
  for (std::sregex_iterator it(text.begin(), text.end(), assignment), end; it != end; ++it) {
    std::string value = (*it)[1];
    value.erase(value.find_last_not_of(" \t\r") + 1);
    variable.is_defined = true;
    AddOnce(value, &variable.values);
  }
  return variable;
}

// A way in which Makefiles use a variable that stands for the SDK or a folder in it.  The text
// after the variable (`rest`) shows for which folder of the SDK the variable stands (`folder`).  If
// the text fits several entries of kSdkUses, the first of these entries counts.
struct SdkUse {
  const char* rest;  // text after the variable, as a regular expression
  const char* folder;
};
constexpr SdkUse kSdkUses[] = {
    {"/bin/mipsel-linux-", ""},
    {"/OPEN_R(?![\\w-])", ""},
    {"/mipsel-linux-", "/bin"},
    {"/(?:bin/(?:mkbin|stubgen2|gzcp)|include/(?:R4000|MCOOP))(?!\\w)", "/OPEN_R"},
    {"/(?:mkbin|stubgen2|gzcp)(?!\\w)", "/OPEN_R/bin"},
    {"/(?:R4000|MCOOP)(?!\\w)", "/OPEN_R/include"},
};

}  // namespace

std::string AdaptMakefile(const std::string& text, const std::string& sdk_root) {
  std::string result;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r' || (i + 1 < text.size() && text[i + 1] != '\n')) result += text[i];
  }
  // The regular expressions kTool and kUsual match whole paths.  A path begins with '/', after a
  // character that no path contains or after a flag such as -I, and ends before a character that no
  // path contains.
  static const std::regex kTool(
      "(^|[^\\w./)}-]|-[ILB])(/[\\w./+-]*?)/(?:bin/mipsel-linux-|OPEN_R/)");
  Names roots = AllMatches(result, kTool, 2);
  static const std::regex kUsual(
      "(^|[^\\w./)}-]|-[ILB])((?:/[\\w.+-]+)+/OPEN_R_SDK)(?=[^\\w.+-]|$)");
  for (const std::string& root : AllMatches(result, kUsual, 2)) AddOnce(root, &roots);
  // Sorts the folders of SDKs so that longer paths come first.  A path may be the beginning of
  // another, so the longer path must be replaced in the Makefile before the shorter one.
  std::sort(roots.begin(), roots.end(),
            [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
  for (const std::string& root : roots) {
    if (root.empty() || root == sdk_root) continue;
    const std::regex whole("(^|[^\\w./)}-]|-[ILB])" + Escaped(root) + "(?=[^\\w.+-]|$)");
    result = std::regex_replace(result, whole, "$1" + sdk_root);
  }
  static const std::regex kStick(
      "(^|[^\\w./)}-])(?!/[mM][sS]/OPEN-R)((?:/[\\w.+-]+)+?)/OPEN-R(?![\\w-])");
  return std::regex_replace(result, kStick, "$1$${" + std::string(kStickVariable) + "}/OPEN-R");
}

std::vector<MakefileVariable> SdkVariables(const std::string& text) {
  std::vector<MakefileVariable> variables;
  for (const SdkUse& use : kSdkUses) {
    const std::regex pattern("\\$[({](\\w+)[)}]" + std::string(use.rest));
    for (const std::string& name : AllMatches(text, pattern)) {
      const bool is_known =
          std::any_of(variables.begin(), variables.end(),
                      [&](const MakefileVariable& other) { return other.name == name; });
      if (is_known) continue;
      variables.push_back(Describe(name, text));
      variables.back().folder = use.folder;
    }
  }
  return variables;
}

std::vector<MakefileVariable> StickVariables(const std::string& text) {
  static const std::regex kUse("\\$[({](\\w+)[)}]/(?:OPEN-R|open-r)(?![\\w-])");
  std::vector<MakefileVariable> variables;
  for (const std::string& name : AllMatches(text, kUse)) variables.push_back(Describe(name, text));
  return variables;
}

bool IsDefinedIn(const std::string& text, const std::string& name) {
  return Describe(name, text).is_defined;
}

std::vector<std::string> InstalledImages(const std::string& text) {
  static const std::regex kImage("(?:OBJS|objs)/([\\w$&#{}~%'()@^`!-]+\\.(?:BIN|bin))(?!\\w)");
  Names names = AllMatches(text, kImage);
  // Drops names of images that begin with a variable of make, whose value is not known here.
  std::erase_if(names, [](const std::string& name) { return name.find('$') == 0; });
  return names;
}

std::vector<std::string> UpwardPaths(const std::string& text) {
  static const std::regex kPath("(?:^|[^\\w./)}]|-[IL])(\\.\\.(?:/[\\w.+-]+)*)");
  return AllMatches(text, kPath);
}

}  // namespace openr_host
