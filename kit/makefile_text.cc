#include "kit/makefile_text.h"

#include <algorithm>
#include <regex>

#include "kit/sdk_paths.h"

namespace openr_host {
namespace {

using Names = std::vector<std::string>;

// The largest number of characters of a word in which paths are looked for.  No path of Linux is
// longer.  std::regex calls itself for each character that it matches, so a word of some 30,000
// characters, such as the data of a script that unpacks itself, would overflow the stack.
constexpr size_t kWordMax = 4096;

void AddOnce(const std::string& name, Names* names) {
  if (std::find(names->begin(), names->end(), name) == names->end()) names->push_back(name);
}

// Cuts `text` at its long words, which have more than kWordMax characters.  In the result, the
// parts with odd indexes are the long words, and the parts with even indexes are the text before,
// between and after them.
Names SplitAtLongWords(const std::string& text) {
  constexpr char kBlanks[] = " \t\r\n";
  Names parts(1);
  for (size_t at = 0; at < text.size();) {
    const size_t begin = std::min(text.find_first_not_of(kBlanks, at), text.size());
    const size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
    parts.back().append(text, at, begin - at);
    if (end - begin <= kWordMax) {
      parts.back().append(text, begin, end - begin);
    } else {
      parts.push_back(text.substr(begin, end - begin));
      parts.emplace_back();
    }
    at = end;
  }
  return parts;
}

// Replaces each match of `pattern` in `text` by `format`.  Does not change words that are longer
// than kWordMax.
std::string ReplacedInWords(const std::string& text, const std::regex& pattern,
                            const std::string& format) {
  const Names parts = SplitAtLongWords(text);
  std::string result;
  for (size_t i = 0; i < parts.size(); ++i)
    result += i % 2 == 0 ? std::regex_replace(parts[i], pattern, format) : parts[i];
  return result;
}

// Returns the texts that the group `group` of `pattern` matches in `text`, each once.  Does not
// look into words that are longer than kWordMax.
Names AllMatches(const std::string& text, const std::regex& pattern, size_t group = 1) {
  Names names;
  const std::string searched = WithoutLongWords(text);
  for (std::sregex_iterator it(searched.begin(), searched.end(), pattern), end; it != end; ++it) {
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
  const std::regex assignment("(?:^|\n)[ \t]*(?:export[ \t]+)?" + name + "[ \t]*[:?+]?=[ \t]*");
  for (std::sregex_iterator it(text.begin(), text.end(), assignment), end; it != end; ++it) {
    const auto begin = static_cast<size_t>(it->position(0) + it->length(0));
    std::string value = text.substr(begin, text.find_first_of("#\n", begin) - begin);
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

std::string WithoutLongWords(const std::string& text) {
  const Names parts = SplitAtLongWords(text);
  std::string result;
  for (size_t i = 0; i < parts.size(); i += 2) result += parts[i];
  return result;
}

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
    result = ReplacedInWords(result, whole, "$1" + sdk_root);
  }
  static const std::regex kStick(
      "(^|[^\\w./)}-])(?!/[mM][sS]/OPEN-R)((?:/[\\w.+-]+)+?)/OPEN-R(?![\\w-])");
  return ReplacedInWords(result, kStick, "$1$${" + std::string(kStickVariable) + "}/OPEN-R");
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
