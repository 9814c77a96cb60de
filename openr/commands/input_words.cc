#include "openr/commands/input_words.h"

#include <cctype>
#include <sstream>

namespace openr_host {

std::set<std::string> WordsInUsage(const std::string& usage) {
  std::string letters = usage;
  for (char& c : letters) {
    if (std::isalpha(static_cast<unsigned char>(c)) == 0) c = ' ';
  }
  std::istringstream stream(letters);
  std::set<std::string> words;
  for (std::string word; stream >> word;) words.insert(word);
  words.erase(usage.substr(0, usage.find(' ')));
  words.erase("or");
  return words;
}

}  // namespace openr_host
