// What the SDK's g++ 3.3 took and today's refuses, and how to say it so that both take it.
//
// A rule looks at one complaint of the compiler and at the text around its place.  Lines never
// move: what follows is found where the person has it.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct Complaint {
  std::string message;  // in English, with ASCII quotes
  std::string file;
  int line = 0;
  int column = 0;  // in bytes
};

struct Edit {
  size_t begin = 0;  // in the text of the complaint's file
  size_t end = 0;    // `begin`: an insertion
  std::string text;
  std::string what;  // for people; of one edit of a repair
};

// The edits that answer a complaint about `text`, which is the whole file; none if no rule fits.
// `headers`: for a header that was not found, the paths of those there are.
std::vector<Edit> RepairOf(const Complaint& complaint, const std::string& text,
                           const std::vector<std::string>& headers);

}  // namespace openr_host
