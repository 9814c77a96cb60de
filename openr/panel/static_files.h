// Finds the files of the panel's built page, and the headers that tell browsers how to treat them.
#pragma once

#include <string>

namespace openr_host {

// Returns the path of the file for the path of a URL ("/" is index.html); "" if there is no such
// file below `folder`.  Files and folders with names that begin with a dot are not found.
std::string FindStaticFile(const std::string& folder, const std::string& url_path);

// Returns the content type of a file by the extension of its name.
std::string ContentTypeOf(const std::string& file);

// Returns the value of the header Cache-Control for the path of a URL.  The names of files in
// /assets contain a hash of their content, so browsers may keep these files for ever.
std::string CacheControlOf(const std::string& url_path);

}  // namespace openr_host
