#include "report/report_page.h"

// The file itself, without a detour over a source that holds its bytes as numbers.
asm(R"(
  .pushsection .rodata
  .global lrcs_page_template
  .global lrcs_page_template_end
lrcs_page_template:
  .incbin ")" LRCS_PAGE_TEMPLATE R"("
lrcs_page_template_end:
  .byte 0
  .popsection
)");

extern "C" {
extern const char lrcs_page_template[];
extern const char lrcs_page_template_end[];
}

namespace lrcs {

std::string_view page_template() {
  return {lrcs_page_template, static_cast<std::size_t>(lrcs_page_template_end - lrcs_page_template)};
}

}  // namespace lrcs
