#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/input_error.h"

namespace lrcs {

// Goes through a text file word by word, and knows where it is.
// Words are split at blanks. Lines end with LF, CR LF or CR; a backslash before the line's end continues it (OBJ).
// A word that begins with # ends its line: the rest is a comment.
// error: every complaint is an InputError at the line and column of the word last taken.
class TextScanner {
 public:
  // Keeps a view of `text`. `file` stands for it in messages; `first_line` is the number of its first line.
  TextScanner(std::string_view text, std::string file, int first_line = 1);

  // Goes to the begin of the next line; false at the end of the file.
  bool next_line();
  // The next word of this line; "" at its end.
  std::string_view word();
  // The next word of the file, over line ends; "" at its end.
  std::string_view next_word();
  // What is left of this line as it stands, without the blanks around it.
  std::string_view rest_of_line();

  // The next cell of a line of cells between commas, without the blanks and the quotes around it, which may be "";
  // nothing at the line's end. A line's cells are not to be mixed with its words.
  std::optional<std::string_view> cell();

  // The next word of this line as a number that is finite; rounded correctly.
  double number();
  // The same of the word last taken. `what` was expected, for the message.
  [[nodiscard]] double number_in(std::string_view word, std::string_view what = "a finite number") const;
  // The next word of this line as an integer.
  std::int64_t integer();

  // Throws InputError with the place of the word last taken.
  [[noreturn]] void fail(const std::string& message) const;
  // The same for a word that is none of what was expected: "expected <what>, found '<word>'".
  [[noreturn]] void fail_expected(std::string_view what, std::string_view found) const;

  [[nodiscard]] int line() const { return line_; }
  // The place of the word last taken.
  [[nodiscard]] Place place() const;
  // Bytes not yet taken.
  [[nodiscard]] std::size_t left() const { return text_.size() - at_; }

 private:
  [[nodiscard]] bool at_line_end() const { return at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '\r'; }
  [[nodiscard]] bool at_continuation() const;
  void take_line_end();
  void strip_cell(std::size_t& end);

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t line_begin_ = 0;
  std::size_t word_begin_ = 0;
  bool cells_left_ = true;
  int line_;
};

// The same letters but for case; ASCII.
[[nodiscard]] bool same_word(std::string_view a, std::string_view b);

// A word of the user's for a message: at most 24 characters, printable ones only.
[[nodiscard]] std::string shown(std::string_view word);

}  // namespace lrcs
