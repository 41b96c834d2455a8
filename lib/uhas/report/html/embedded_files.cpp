#include "uhas/report/html/embedded_files.hpp"

// the assembler takes in whole files, from UHAS_REPORT_FOLDER, quicker than a compiler reads them as arrays
#define UHAS_EMBED(symbol, file)                                                     \
  asm(".section .rodata\n"                                                           \
      ".hidden " #symbol "\n.hidden " #symbol                                        \
      "_end\n"                                                                       \
      ".global " #symbol "\n.global " #symbol "_end\n" #symbol                       \
      ":\n"                                                                          \
      ".incbin \"" UHAS_REPORT_FOLDER "/" file "\"\n" #symbol "_end:\n.previous\n"); \
  extern "C" __attribute__((visibility("hidden"))) const char symbol[], symbol##_end[]

UHAS_EMBED(uhas_report_page, "page.html");
UHAS_EMBED(uhas_hand_module, "hand_module.wasm");

namespace uhas {

std::string_view embedded_page() { return {uhas_report_page, uhas_report_page_end}; }

std::span<const std::byte> embedded_hand_module() {
  return {reinterpret_cast<const std::byte*>(uhas_hand_module),
          reinterpret_cast<const std::byte*>(uhas_hand_module_end)};
}

}  // namespace uhas
