#include "report/report_page.h"

#include <openssl/evp.h>
#include <zlib.h>

#include <stdexcept>

namespace lrcs {
namespace {

constexpr std::string_view marker = "<!-- lrcs:data -->";

std::string compressed(const std::vector<std::uint8_t>& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, bytes.data(), static_cast<uLong>(bytes.size()), 9) !=
      Z_OK)
    throw std::runtime_error("the report's facets cannot be compressed");
  packed.resize(size);
  return packed;
}

std::string base64(const std::string& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

// No tag can begin within it.
std::string within_script(const std::string& json) {
  std::string text;
  for (const char c : json) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

}  // namespace

std::string report_page(const std::string& json, const std::vector<std::uint8_t>& facets) {
  const std::string_view page = page_template();
  const std::size_t at = page.find(marker);
  if (at == std::string_view::npos) throw std::logic_error("the report's page has no place for its numbers");
  std::string whole(page.substr(0, at));
  whole += "<script type=\"application/json\" id=\"lrcs-data\">" + within_script(json) + "</script>\n";
  whole += "<script type=\"text/plain\" id=\"lrcs-facets\">" + base64(compressed(facets)) + "</script>";
  whole += page.substr(at + marker.size());
  return whole;
}

}  // namespace lrcs
