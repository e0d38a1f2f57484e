#include "lib/tools/page/page_script.h"

#include <sodium.h>

#include <array>

namespace shoal {

namespace {

constexpr std::string_view kImport = "import ";
constexpr std::string_view kExport = "export ";
/// The last line of uPlot, whose own names are its own scope.
constexpr std::string_view kExportOfUplot = "export { uPlot as default };";

/// Takes the next line off `text`, with its end.
std::string_view TakeLine(std::string_view* text) {
  const size_t end = text->find('\n');
  const size_t size = end == text->npos ? text->size() : end + 1;
  const std::string_view line = text->substr(0, size);
  text->remove_prefix(size);
  return line;
}

bool EndsStatement(std::string_view line) { return line.ends_with(";\n") || line.ends_with(';'); }

void AppendModule(std::string_view module, std::string* script) {
  const bool is_uplot = module.find(kExportOfUplot) != module.npos;
  if (is_uplot) *script += "const uPlot = (() => {\n";
  while (!module.empty()) {
    std::string_view line = TakeLine(&module);
    if (line.starts_with(kExportOfUplot)) {
      *script += "return uPlot;\n";
    } else if (line.starts_with(kImport)) {
      while (!EndsStatement(line) && !module.empty()) line = TakeLine(&module);
    } else {
      if (line.starts_with(kExport)) line.remove_prefix(kExport.size());
      *script += line;
    }
  }
  if (is_uplot) *script += "})();\n";
}

}  // namespace

std::string OneScript(std::span<const std::string_view> modules) {
  std::string script = "'use strict';\n(() => {\n";
  for (const std::string_view module : modules) AppendModule(module, &script);
  return script + "})();\n";
}

std::string ScriptHash(std::string_view script) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
  crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(script.data()),
                     script.size());
  constexpr int kVariant = sodium_base64_VARIANT_ORIGINAL;
  std::array<char, sodium_base64_ENCODED_LEN(crypto_hash_sha256_BYTES, kVariant)> text{};
  sodium_bin2base64(text.data(), text.size(), hash.data(), hash.size(), kVariant);
  return "'sha256-" + std::string(text.data()) + "'";
}

}  // namespace shoal
