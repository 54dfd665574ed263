#include "base/yaml_document.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string_view>

namespace lrcs {
namespace {

constexpr std::size_t deepest = 100;  // levels: no input of ours has ten; recursion over them stays shallow
constexpr std::size_t largest = std::size_t{16} * 1048576;  // bytes
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// Builds the document from the parser's events: unlike yaml-cpp's own tree this sees every key, and each value's depth.
class Builder : public YAML::EventHandler {
 public:
  explicit Builder(std::string file) : file_(std::move(file)) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ > 0) throw InputError(place_of(mark), "a second document starts here, expected one");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    finish(begin(YamlValue::Kind::null, mark, anchor));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const std::size_t target = anchors_.at(anchor);
    if (std::any_of(open_.begin(), open_.end(), [&](const Open& o) { return o.index == target; }))
      throw InputError(place_of(mark), "an alias stands inside the value it names");
    finish(target);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& text) override {
    const std::size_t index = begin(YamlValue::Kind::scalar, mark, anchor);
    document_.values[index].text = text;
    document_.values[index].quoted = tag != "?";
    finish(index);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    descend(begin(YamlValue::Kind::sequence, mark, anchor));
  }
  void OnSequenceEnd() override { ascend(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    descend(begin(YamlValue::Kind::mapping, mark, anchor));
  }
  void OnMapEnd() override { ascend(); }

  [[nodiscard]] Place place_of(const YAML::Mark& mark) const { return {file_, mark.line + 1, mark.column + 1}; }
  [[nodiscard]] YamlDocument take() { return std::move(document_); }

 private:
  struct Open {
    std::size_t index;
    std::map<std::string, int, std::less<>> lines_of_keys = {};
    bool key_is_next = true;
  };

  std::size_t begin(YamlValue::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor) {
    const std::size_t index = document_.values.size();
    if (anchor != YAML::NullAnchor) anchors_[anchor] = index;
    YamlValue value;
    value.kind = kind;
    value.place = place_of(mark);
    document_.values.push_back(std::move(value));
    return index;
  }

  void descend(std::size_t index) {
    open_.push_back({index});
    check_depth(index, open_.size());
  }
  void ascend() {
    const std::size_t index = open_.back().index;
    open_.pop_back();
    finish(index);
  }

  // Hangs a complete value into the innermost open one.
  void finish(std::size_t index) {
    if (open_.empty()) return;
    Open& parent = open_.back();
    YamlValue& owner = document_.values[parent.index];
    if (owner.kind == YamlValue::Kind::sequence) {
      owner.items.push_back(index);
    } else if (parent.key_is_next) {
      check_key(parent, index);
      owner.entries.emplace_back(index, 0);
    } else {
      owner.entries.back().second = index;
    }
    if (owner.kind == YamlValue::Kind::mapping) parent.key_is_next = !parent.key_is_next;
    owner.depth = std::max(owner.depth, document_.values[index].depth + 1);
    check_depth(index, open_.size() + document_.values[index].depth);
  }

  void check_key(Open& parent, std::size_t index) const {
    const YamlValue& key = document_.values[index];
    if (key.kind != YamlValue::Kind::scalar) throw InputError(key.place, "expected a key that is a word");
    const auto [first, is_new] = parent.lines_of_keys.emplace(key.text, key.place.line);
    if (!is_new)
      throw InputError(key.place, fmt::format("duplicate key '{}' (first on line {})", key.text, first->second));
  }
  void check_depth(std::size_t index, std::size_t depth) const {
    if (depth > deepest)
      throw InputError(document_.values[index].place, fmt::format("nested more than {} levels deep", deepest));
  }

  std::string file_;
  YamlDocument document_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, std::size_t> anchors_;
  int documents_ = 0;
};

// Bytes of the UTF-8 sequence that a lead byte announces; 0: no lead byte.
std::size_t sequence_length(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead < 0xe0) return 2;
  if (lead >= 0xe0 && lead < 0xf0) return 3;
  return lead >= 0xf0 && lead < 0xf5 ? 4 : 0;
}

// yaml-cpp ends a document silently at a byte 4, and reads other encodings: text that is not plain UTF-8 stops here.
void check_text(std::string_view text, const std::string& file) {
  Place place{file, 1, 1};
  for (std::size_t k = 0; k < text.size(); ++place.column) {
    const auto byte = static_cast<unsigned char>(text[k]);
    const std::size_t length = sequence_length(byte);
    const bool control = (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7f;
    if (control || length == 0 || k + length > text.size())
      throw InputError(place, fmt::format("byte 0x{:02x} found, expected text in UTF-8", byte));
    for (std::size_t j = 1; j < length; ++j)
      if ((static_cast<unsigned char>(text[k + j]) & 0xc0U) != 0x80)
        throw InputError(place, fmt::format("byte 0x{:02x} found, expected text in UTF-8", byte));
    k += length;
    if (byte == '\n') place = {file, place.line + 1, 0};
  }
}

}  // namespace

YamlDocument yaml_document(const std::string& text, const std::string& file) {
  std::string_view content = text;
  if (content.starts_with(byte_order_mark)) content.remove_prefix(byte_order_mark.size());
  if (content.size() > largest)
    throw InputError(Place{file}, fmt::format("is larger than {} MiB, expected a YAML file", largest / 1048576));
  check_text(content, file);
  Builder builder(file);
  try {
    std::istringstream in{std::string(content)};
    YAML::Parser parser(in);
    while (parser.HandleNextDocument(builder)) {}
  } catch (const YAML::Exception& error) {
    throw InputError(error.mark.is_null() ? Place{file} : builder.place_of(error.mark), error.msg);
  }
  YamlDocument document = builder.take();
  if (document.values.empty()) throw InputError(Place{file}, "is empty, expected YAML");
  return document;
}

}  // namespace lrcs
