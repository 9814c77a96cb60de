#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "openr/data/table.h"

namespace openr_host {
namespace {

// A column with the time: its name in the first line of a CSV file, and the factor that converts
// its values to seconds.
struct TimeColumn {
  const char* name;
  double factor;
};
constexpr TimeColumn kTimeColumns[] = {{"time_s", 1}, {"time_ms", 1e-3}, {"time_us", 1e-6}};

// Splits a line of comma-separated values into fields.  A field in quotes may have commas.  Two
// quotes in such a field stand for one quote.
std::vector<std::string> FieldsOf(std::string_view line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += c;
      ++i;
    } else if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

// Returns the number in a field of a table; NaN if `text` is empty, "inf" or "nan", which cannot be
// drawn; nullopt if `text` is no number.
std::optional<double> NumberOfField(const std::string& text) {
  if (text.empty()) return std::numeric_limits<double>::quiet_NaN();
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return std::isfinite(number) ? number : std::numeric_limits<double>::quiet_NaN();
}

class CsvReader {
 public:
  CsvReader(const std::string& file, std::string_view bytes, const OnBytesRead& on_read)
      : file_(file), size_(bytes.size()), rest_(bytes), on_read_(on_read) {}

  Table Read() {
    std::string line;
    if (!NextLine(&line)) {
      throw std::runtime_error(
          file_ + (note_.empty() ? ": is empty" : ": has one line only, which has no end"));
    }
    names_ = FieldsOf(line);
    FindTime();
    columns_.resize(names_.size());
    while (NextLine(&line)) {
      AddLine(line);
      if (on_read_) on_read_(size_ - rest_.size());
    }
    return TableOfColumns();
  }

 private:
  struct Values {
    // True: the column of the table has a field that is not a number, so the column is left out.
    bool is_text = false;
    bool has_number = false;
    Series series;
  };

  // Sets `line` to the next line of the file.  Returns false at the end of the file.  Also returns
  // false if the last line has no newline at its end: then the program that wrote the file was
  // killed, and the line may not be complete.
  bool NextLine(std::string* line) {
    if (rest_.empty()) return false;
    const size_t end = rest_.find('\n');
    if (end == std::string::npos) {
      AddNote(fmt::format("{}: the last line has no end and is left out", file_));
      return false;
    }
    *line = rest_.substr(0, end);
    if (line->ends_with('\r')) line->pop_back();
    rest_.remove_prefix(end + 1);
    ++number_;
    return true;
  }

  void AddNote(const std::string& note) { note_ += (note_.empty() ? "" : "\n") + note; }

  void FindTime() {
    for (const TimeColumn& column : kTimeColumns) {
      for (size_t i = 0; i < names_.size(); ++i) {
        if (names_[i] != column.name) continue;
        time_ = i;
        factor_ = column.factor;
        return;
      }
    }
    throw std::runtime_error(
        fmt::format("{}:1: no column time_s, time_ms or time_us, so there is nothing to draw the "
                    "values over; the file of openr run --log-data has time_s",
                    file_));
  }

  void AddLine(const std::string& line) {
    if (line.empty()) return;
    const std::vector<std::string> fields = FieldsOf(line);
    if (fields.size() != names_.size()) {
      throw std::runtime_error(fmt::format("{}:{}: {} fields, but the first line names {}", file_,
                                           number_, fields.size(), names_.size()));
    }
    const std::optional<double> time = NumberOfField(fields[time_]);
    if (!time || std::isnan(*time)) {
      throw std::runtime_error(fmt::format("{}:{}: '{}' in column {} is no time", file_, number_,
                                           fields[time_], names_[time_]));
    }
    for (size_t i = 0; i < fields.size(); ++i) {
      if (i != time_) AddField(i, *time * factor_, fields[i]);
    }
  }

  void AddField(size_t column, double time_s, const std::string& field) {
    Values& values = columns_[column];
    if (values.is_text) return;
    const std::optional<double> number = NumberOfField(field);
    if (!number && values.has_number) {
      AddNote(fmt::format("{}:{}: '{}' in column {} is no number; the column is left out", file_,
                          number_, field, names_[column]));
    }
    values.is_text = !number;
    if (!number || std::isnan(*number)) return;
    values.has_number = true;
    values.series.time_s.push_back(time_s);
    values.series.values.push_back(*number);
  }

  Table TableOfColumns() {
    Table table;
    table.note = note_;
    for (size_t i = 0; i < columns_.size(); ++i) {
      if (i == time_ || columns_[i].is_text) continue;
      columns_[i].series.name = names_[i];
      table.series.push_back(std::move(columns_[i].series));
    }
    return table;
  }

  const std::string& file_;
  const size_t size_;  // number of bytes of the whole table
  std::string_view rest_;
  const OnBytesRead& on_read_;
  int number_ = 0;  // number of the table's line that was read last
  std::vector<std::string> names_;
  size_t time_ = 0;    // index of the table's column with the time
  double factor_ = 1;  // factor that converts the values of the time column to seconds
  std::vector<Values> columns_;
  std::string note_;
};

}  // namespace

Table ReadCsvTable(const std::string& file, std::string_view bytes, const OnBytesRead& on_read) {
  return CsvReader(file, bytes, on_read).Read();
}

}  // namespace openr_host
