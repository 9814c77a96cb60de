#include "tests/fuzz/mutate.h"

#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <vector>

#include "runtime/base/hasher.h"
#include "runtime/stick/gzip.h"

namespace openr_host {
namespace {

constexpr const char* kNumbers[] = {"0",     "1",          "2",   "3",   "99",  "100",
                                    "127",   "128",        "255", "256", "257", "32767",
                                    "65535", "2147483647", "-1",  "0.5"};
constexpr uint32_t kWords[] = {0,   1,   2,      3,      127,        128,       255,
                               256, 257, 0x7fff, 0xffff, 0x7fffffff, 0xffffffff};

struct Piece {
  size_t begin = 0, size = 0;
};

bool IsOfWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool IsOfText(char c) { return std::isprint(static_cast<unsigned char>(c)) != 0 || c == '\n'; }

bool IsOfSymbol(char c) { return std::ispunct(static_cast<unsigned char>(c)) != 0 && c != '_'; }

// Returns the longest pieces of `text` whose characters all fit.
std::vector<Piece> PiecesOf(std::string_view text, bool (*fits)(char)) {
  std::vector<Piece> pieces;
  for (size_t at = 0; at < text.size();) {
    size_t end = at;
    while (end < text.size() && fits(text[end])) ++end;
    if (end > at) pieces.push_back({at, end - at});
    at = std::max(end, at + 1);
  }
  return pieces;
}

// Returns the lines of `text`, each with its line end.
std::vector<std::string> LinesOf(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const size_t size = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.emplace_back(text.substr(0, size));
    text.remove_prefix(size);
  }
  return lines;
}

std::string TextOf(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

size_t Below(size_t limit, FuzzRandom* random) { return (*random)() % limit; }

// Returns a number for the place of `number`, a row of digits: a small one, a limit of a type, a
// near one or a multiple.
std::string OtherNumber(const std::string& number, FuzzRandom* random) {
  const size_t kind = Below(4, random);
  if (kind == 0) return std::to_string(Below(200, random));
  if (kind == 1 || number.size() >= 10) return kNumbers[Below(std::size(kNumbers), random)];
  const long long value = std::stoll(number);
  if (kind == 2) return std::to_string(value + static_cast<int>(Below(5, random)) - 2);
  return std::to_string(value * (2 + static_cast<int>(Below(9, random))));
}

// Returns a hexadecimal number for the place of `number`, which begins with "0x": as long as that
// one, with one other digit or a small value.
std::string OtherHexNumber(std::string number, FuzzRandom* random) {
  constexpr char kDigits[] = "0123456789abcdef";
  const size_t digits = number.size() - 2;
  if (Below(2, random) == 0) std::fill_n(number.begin() + 2, digits, '0');
  number[2 + Below(digits, random)] = kDigits[Below(16, random)];
  return number;
}

// Returns what to put in the place of `word`: a number for a number, whose unit stays, and for a
// name the name shortened, another word of the text, or a word of the dictionary.
std::string Substitute(const std::string& word, std::string_view text,
                       const std::vector<Piece>& pieces, const FuzzWords& words,
                       FuzzRandom* random) {
  const bool is_number = std::isdigit(static_cast<unsigned char>(word[0])) != 0;
  const size_t kind = Below(8, random);
  if (is_number && kind < 6) {
    if (word.size() > 2 && word.starts_with("0x")) return OtherHexNumber(word, random);
    const size_t digits = std::min(word.find_first_not_of("0123456789"), word.size());
    return OtherNumber(word.substr(0, digits), random) + word.substr(digits);
  }
  if (kind < 2) return word.substr(0, 1 + Below(word.size(), random));
  if (kind < 6 && !words.empty()) return words[Below(words.size(), random)];
  const Piece other = pieces[Below(pieces.size(), random)];
  return std::string(text.substr(other.begin, other.size));
}

std::string MutateWord(std::string_view text, const std::vector<Piece>& pieces,
                       const FuzzWords& words, bool everywhere, FuzzRandom* random) {
  const Piece chosen = pieces[Below(pieces.size(), random)];
  const std::string word(text.substr(chosen.begin, chosen.size));
  const std::string other = Substitute(word, text, pieces, words, random);
  std::string result;
  size_t at = 0;
  for (const Piece& piece : pieces) {
    const bool is_chosen =
        piece.begin == chosen.begin || (everywhere && text.substr(piece.begin, piece.size) == word);
    if (!is_chosen) continue;
    result += text.substr(at, piece.begin - at);
    result += other;
    at = piece.begin + piece.size;
  }
  return result += text.substr(at);
}

// Puts another symbol, such as "==" or ">", in the place of one.  Takes it from the text or from
// the dictionary.
std::string MutateSymbol(std::string_view text, const FuzzWords& words, FuzzRandom* random) {
  const std::vector<Piece> pieces = PiecesOf(text, IsOfSymbol);
  if (pieces.empty()) return std::string(text);
  std::vector<std::string_view> symbols;
  for (const Piece& piece : pieces) symbols.push_back(text.substr(piece.begin, piece.size));
  for (const std::string& word : words) {
    if (std::all_of(word.begin(), word.end(), IsOfSymbol)) symbols.push_back(word);
  }
  const Piece chosen = pieces[Below(pieces.size(), random)];
  std::string result(text.substr(0, chosen.begin));
  result += symbols[Below(symbols.size(), random)];
  return result += text.substr(chosen.begin + chosen.size);
}

// Multiplies the whole numbers in one column of all lines, such as the times of a table, so that
// numbers that rise go on rising.
std::string MutateColumn(std::string_view text, FuzzRandom* random) {
  const char separator = text.find(',') != std::string_view::npos ? ',' : ' ';
  std::vector<std::string> lines = LinesOf(text);
  const std::string& line = lines[Below(lines.size(), random)];
  const auto separators = static_cast<size_t>(std::count(line.begin(), line.end(), separator));
  const size_t column = Below(separators + 1, random);
  const auto factor = static_cast<int>(2 + Below(9, random));
  for (std::string& row : lines) {
    size_t begin = 0;
    for (size_t i = 0; i < column && begin <= row.size(); ++i) {
      begin = std::min(row.find(separator, begin), row.size()) + 1;
    }
    if (begin > row.size()) continue;
    const size_t end =
        std::min(row.find_first_of(std::string("\r\n") + separator, begin), row.size());
    const std::string field = row.substr(begin, end - begin);
    const bool is_number = !field.empty() && field.size() < 10 &&
                           field.find_first_not_of("0123456789") == std::string::npos;
    if (is_number) row.replace(begin, end - begin, std::to_string(std::stoll(field) * factor));
  }
  return TextOf(lines);
}

}  // namespace

bool IsText(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](unsigned char c) {
    return c == 0x7f || (c < 0x20 && c != '\n' && c != '\r' && c != '\t');
  });
}

std::string MutateText(std::string_view text, const FuzzWords& words, FuzzRandom* random) {
  const std::vector<Piece> pieces = PiecesOf(text, IsOfWord);
  if (pieces.empty()) return std::string(text);
  const size_t kind = Below(12, random);
  if (kind < 5) return MutateWord(text, pieces, words, false, random);
  if (kind < 7) return MutateWord(text, pieces, words, true, random);
  if (kind == 7) return MutateSymbol(text, words, random);
  if (kind == 8) return MutateColumn(text, random);
  std::vector<std::string> lines = LinesOf(text);
  const size_t from = Below(lines.size(), random);
  const std::string line = lines[from];
  if (kind != 9) lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(from));
  if (kind != 10) {
    const size_t to = Below(lines.size() + 1, random);
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(to), line);
  }
  return TextOf(lines);
}

std::string MutateTextIn(std::string bytes, const FuzzWords& words, FuzzRandom* random) {
  constexpr size_t kTextBytesMin = 8;  // shorter rows are mostly numbers
  std::vector<Piece> texts = PiecesOf(bytes, IsOfText);
  std::erase_if(texts, [](const Piece& piece) { return piece.size < kTextBytesMin; });
  if (texts.empty()) return bytes;
  const Piece chosen = texts[Below(texts.size(), random)];
  std::string text =
      MutateText(std::string_view(bytes).substr(chosen.begin, chosen.size), words, random);
  text.resize(std::min(std::max(text.size(), chosen.size), bytes.size() - chosen.begin));
  return bytes.replace(chosen.begin, text.size(), text);
}

std::string MutateNumber(std::string bytes, FuzzRandom* random) {
  const size_t size = size_t{1} << Below(3, random);
  if (bytes.size() < size) return bytes;
  char* const place = &bytes[Below(bytes.size() - size + 1, random)];
  uint32_t value = 0;
  std::memcpy(&value, place, size);
  switch (Below(3, random)) {
    case 0:
      value = static_cast<uint32_t>(Below(256, random));
      break;
    case 1:
      value = kWords[Below(std::size(kWords), random)];
      break;
    default:
      value += static_cast<uint32_t>(Below(9, random)) - 4;
  }
  std::memcpy(place, &value, size);
  return bytes;
}

std::string JoinTexts(std::string_view first, std::string_view second, FuzzRandom* random) {
  if (Below(2, random) == 0) return std::string(first) + std::string(second);
  std::vector<std::string> lines = LinesOf(first);
  const std::vector<std::string> others = LinesOf(second);
  if (others.empty()) return std::string(first);
  const size_t begin = Below(others.size(), random);
  const size_t end = begin + 1 + Below(others.size() - begin, random);
  const size_t to = Below(lines.size() + 1, random);
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(to),
               others.begin() + static_cast<std::ptrdiff_t>(begin),
               others.begin() + static_cast<std::ptrdiff_t>(end));
  return TextOf(lines);
}

void FixRecording(std::string* bytes) {
  constexpr size_t kBegin = 8 + 4;  // magic and version
  // The header is a text behind its length, a number of seven bits per byte.
  size_t at = kBegin, length = 0;
  for (int shift = 0; at < bytes->size() && shift < 28; shift += 7) {
    const auto byte = static_cast<unsigned char>((*bytes)[at++]);
    length |= static_cast<size_t>(byte & 0x7f) << shift;
    if (byte < 0x80) break;
  }
  at += length;
  constexpr size_t kHead = 4 + 8;  // size and checksum of a block
  while (at < bytes->size() && bytes->size() - at >= kHead) {
    uint32_t size;
    std::memcpy(&size, bytes->data() + at, sizeof size);
    if (size > bytes->size() - at - kHead) return;
    const uint64_t checksum = HashBytes(bytes->data() + at + kHead, size);
    std::memcpy(bytes->data() + at + 4, &checksum, sizeof checksum);
    at += kHead + size;
  }
}

std::string Decompress(std::string_view bytes) {
  std::string content;
  const bool is_whole = Gunzip(std::string(bytes), &content) == GzipResult::kWhole;
  return is_whole ? content : "";
}

std::string Compress(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, 1, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
    return "";
  }
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const bool is_whole = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  packed.resize(is_whole ? stream.total_out : 0);
  deflateEnd(&stream);
  return packed;
}

}  // namespace openr_host
