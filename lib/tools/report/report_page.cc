#include "lib/tools/report/report_page.h"

#include <array>
#include <string_view>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/tools/page/module_bundle.h"
#include "lib/tools/page/script_hash.h"
#include "lib/tools/report/embedded_page.h"
#include "lib/tools/report/page_data.h"
#include "lib/tools/report/report_text.h"

namespace shoal {

namespace {

/// The files of the page by their kinds.
struct PageParts {
  std::string_view frame;  ///< HTML with places for the rest.
  std::string styles;
  ModuleTexts modules;
};

PageParts EmbeddedParts() {
  PageParts parts;
  for (const EmbeddedFile& file : EmbeddedPage()) {
    const std::string_view text(reinterpret_cast<const char*>(file.bytes.data()),
                                file.bytes.size());
    if (file.path.ends_with(".html")) parts.frame = text;
    if (file.path.ends_with(".css")) parts.styles += std::string(text) + '\n';
    if (file.path.ends_with(".js")) parts.modules.emplace(file.path, text);
  }
  return parts;
}

std::string HtmlText(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    switch (letter) {
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

}  // namespace

std::string ReportPage(const CampaignResults& results, const ReportTables& tables,
                       const std::string& dir) {
  const PageParts parts = EmbeddedParts();
  const Result<std::string> bundle = BundleModules(parts.modules, "/campaign/report.js");
  SHOAL_CHECK(bundle.ok(), "the modules of web/campaign are embedded, and import no other");
  const std::string& script = *bundle;
  // In the order of the frame: what was put in is not looked at again.
  const std::array<std::pair<std::string_view, std::string>, 6> places = {
      std::pair("{{policy}}",
                "default-src 'none'; img-src data:; base-uri 'none'; form-action 'none'; "
                "style-src " +
                    ScriptHash("\n" + parts.styles + "\n") + "; script-src " + ScriptHash(script)),
      std::pair("{{title}}", HtmlText(results.campaign.file)),
      std::pair("{{styles}}", parts.styles),
      std::pair("{{text}}", HtmlText(ReportText(results, tables, false))),
      std::pair("{{data}}", PageData(results, tables, dir)),
      std::pair("{{script}}", script)};
  std::string page;
  size_t done = 0;
  for (const auto& [place, text] : places) {
    const size_t at = parts.frame.find(place, done);
    SHOAL_CHECK(at != parts.frame.npos, "web/campaign/report.html has each place, in this order");
    page += parts.frame.substr(done, at - done);
    page += text;
    done = at + place.size();
  }
  return page += parts.frame.substr(done);
}

}  // namespace shoal
