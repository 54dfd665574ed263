#include "base/text_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace lrcs {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// A number's text without the plus sign that std::from_chars does not know.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

template <class T>
bool parse(std::string_view word, T& value) {
  const std::string_view text = without_plus(word);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

TextScanner::TextScanner(std::string_view text, std::string file, int first_line)
    : text_(text), file_(std::move(file)), line_(first_line) {}

bool TextScanner::at_continuation() const {
  return text_[at_] == '\\' && at_ + 1 < text_.size() && (text_[at_ + 1] == '\n' || text_[at_ + 1] == '\r');
}

void TextScanner::take_line_end() {
  at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
  line_begin_ = word_begin_ = at_;
  cells_left_ = true;
  ++line_;
}

bool TextScanner::next_line() {
  at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
  if (at_ == text_.size()) return false;
  take_line_end();
  return at_ < text_.size();
}

std::string_view TextScanner::word() {
  while (at_ < text_.size() && (is_blank(text_[at_]) || at_continuation())) {
    if (!is_blank(text_[at_++])) take_line_end();
  }
  word_begin_ = at_;
  if (at_line_end() || text_[at_] == '#') return {};
  while (!at_line_end() && !is_blank(text_[at_]) && !at_continuation()) ++at_;
  return text_.substr(word_begin_, at_ - word_begin_);
}

std::string_view TextScanner::next_word() {
  while (true) {
    const std::string_view found = word();
    if (!found.empty() || !next_line()) return found;
  }
}

std::string_view TextScanner::rest_of_line() {
  std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  while (at_ < end && is_blank(text_[at_])) ++at_;
  word_begin_ = std::exchange(at_, end);
  while (end > word_begin_ && is_blank(text_[end - 1])) --end;
  return text_.substr(word_begin_, end - word_begin_);
}

void TextScanner::strip_cell(std::size_t& end) {
  while (word_begin_ < end && is_blank(text_[word_begin_])) ++word_begin_;
  while (end > word_begin_ && is_blank(text_[end - 1])) --end;
  if (end < word_begin_ + 2 || text_[word_begin_] != '"' || text_[end - 1] != '"') return;
  ++word_begin_;
  --end;
}

std::optional<std::string_view> TextScanner::cell() {
  word_begin_ = at_;
  if (!cells_left_ || (at_ == line_begin_ && at_line_end())) return std::nullopt;
  std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
  cells_left_ = end < text_.size() && text_[end] == ',';
  at_ = cells_left_ ? end + 1 : end;
  strip_cell(end);
  return text_.substr(word_begin_, end - word_begin_);
}

double TextScanner::number() {
  return number_in(word());
}

double TextScanner::number_in(std::string_view word, std::string_view what) const {
  double value = 0.0;
  if (!parse(word, value) || !std::isfinite(value)) fail_expected(what, word);
  return value;
}

std::int64_t TextScanner::integer() {
  const std::string_view found = word();
  std::int64_t value = 0;
  if (!parse(found, value)) fail_expected("an integer", found);
  return value;
}

Place TextScanner::place() const {
  return {file_, line_, static_cast<int>(word_begin_ - line_begin_) + 1};
}

void TextScanner::fail(const std::string& message) const {
  throw InputError(place(), message);
}

void TextScanner::fail_expected(std::string_view what, std::string_view found) const {
  if (!found.empty()) fail(fmt::format("expected {}, found '{}'", what, shown(found)));
  fail(fmt::format("expected {}, found the end of the {}", what, at_ == text_.size() ? "file" : "line"));
}

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

std::string shown(std::string_view word) {
  constexpr std::size_t longest = 24;
  std::string text(word.substr(0, longest));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return word.size() > longest ? text + "..." : text;
}

}  // namespace lrcs
