// Table: values over time that were read from a file, for charts.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// The values of one quantity, in order of time.
struct Series {
  std::string name;  // name of the quantity, such as "joint.LF_j1"
  std::vector<double> time_s, values;
};

struct Table {
  std::vector<Series> series;
  std::string note;  // a remark for the user, such as that the file was cut; "": none
};

// A function that is called again and again while a file is read, with the number of bytes that
// have been read; null: nothing is called.
using OnBytesRead = std::function<void(size_t count)>;

// The type of the functions that read a table of values over time from a file.
using TableReader = Table(const std::string& file, std::string_view bytes,
                          const OnBytesRead& on_read);

// Reads comma-separated values: a file of `openr run --log-data`, or any file with a column time_s,
// time_ms or time_us.  `bytes` is the content of `file`, whose name is used in error messages.
// Throws std::runtime_error "FILE:LINE: what is wrong".
Table ReadCsvTable(const std::string& file, std::string_view bytes,
                   const OnBytesRead& on_read = {});

// Reads a table from `bytes`, the content of an MCAP file without compression.  `file` is the name
// of the file for error messages.  Throws std::runtime_error if the content is wrong.
Table ReadMcapTable(const std::string& file, std::string_view bytes,
                    const OnBytesRead& on_read = {});

}  // namespace openr_host
